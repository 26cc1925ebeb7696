"""The rows of the table: what is measured, the peer, and the goal."""
import json
import statistics
import tempfile

from measure import Failed, call

CRFH_RESPONSES = {6: 3, 8: 4, 12: 6}  # dimensions: responses at each of two scales


def row(what, peer, goal, figure, met, detail):
    return {'what': what, 'peer': peer, 'goal': goal, 'figure': figure, 'met': met,
            'detail': detail}


class Row:
    """Something to measure; `run` returns a figure and its parts."""

    def __init__(self, what, peer, least=None, most=None, unit=''):
        self.what, self.peer, self.least, self.most, self.unit = what, peer, least, most, unit

    def goal(self):
        if self.least is not None:
            return f'at least {self.least:g}{self.unit}'
        return f'at most {self.most:g}{self.unit}'

    def met(self, figure):
        return figure >= self.least if self.least is not None else figure <= self.most

    def measure(self, context):
        try:
            figure, detail = self.run(context)
        except Failed as failure:
            return row(self.what, self.peer, self.goal(), None, False, str(failure))
        return row(self.what, self.peer, self.goal(), figure, self.met(figure), detail)


class Times(Row):
    """The ratio to the peer in the same program: at least (faster) or at most (slower)."""

    def __init__(self, what, peer, program, ours, theirs, **goal):
        super().__init__(what, peer, **goal)
        self.program, self.ours, self.theirs = program, ours, theirs

    def run(self, context):
        ours = context.programs.milliseconds(self.program, self.ours)
        theirs = context.programs.milliseconds(self.program, self.theirs)
        figure = theirs / ours if self.least is not None else ours / theirs
        return figure, f'{ours:.3g} ms beside {theirs:.3g} ms'


class Milliseconds(Row):
    """An absolute time."""

    def __init__(self, what, program, name, most):
        super().__init__(what, '-', most=most, unit=' ms')
        self.program, self.name = program, name

    def run(self, context):
        return context.programs.milliseconds(self.program, self.name), self.name


class Rates(Row):
    """The ratio of products per second."""

    def __init__(self, what, peer, theirs, **goal):
        super().__init__(what, peer, **goal)
        self.theirs = theirs

    def run(self, context):
        def rate(name):
            return context.programs.counter('local_match_benchmark', name, 'products')
        ours, theirs = rate('localMatch'), rate(self.theirs)
        return ours / theirs, f'{ours / 1e9:.3g} beside {theirs / 1e9:.3g} billion products a second'


class CrfhGrowth(Row):
    """The time for more dimensions relative to six, divided by the ratio of their responses."""

    def __init__(self, dimensions):
        super().__init__(f'CRFH, {dimensions} dimensions, by the response', 'CRFH, 6 dimensions',
                         most=1)
        self.dimensions = dimensions

    def run(self, context):
        def time(dimensions):
            name = f'crfh/{dimensions}_dimensions/ours'
            return context.programs.milliseconds('crfh_benchmark', name)
        growth = time(self.dimensions) / time(6)
        responses = CRFH_RESPONSES[self.dimensions] / CRFH_RESPONSES[6]
        return growth / responses, f'{growth:.2f} times the time for {responses:.2f} the responses'


class Training(Row):
    IMAGES, ROUNDS = 1000, 3

    def __init__(self):
        super().__init__(f'training, {self.IMAGES} images, 5 rooms', 'scikit-learn', least=10)

    def run(self, context):
        program = context.programs.path('training_benchmark')
        peer = [context.python, context.source / 'benchmark/training_peer.py']
        if not context.has_module('sklearn'):
            raise Failed('skipped: python3-sklearn is not installed')
        with tempfile.TemporaryDirectory() as folder:
            environment = context.programs.environment
            call([program, 'write', folder, self.IMAGES], env=environment)
            ours, theirs = [], []
            for _ in range(self.ROUNDS):
                ours.append(float(call([program, 'run', folder], env=environment)))
                theirs.append(float(call(peer + [folder], env=environment)))
        ours, theirs = statistics.median(ours), statistics.median(theirs)
        return theirs / ours, f'{ours:.3g} s beside {theirs:.3g} s'


class Node(Row):
    """A figure of the node's run, which these rows share."""

    def __init__(self, what, key, run_name='paced', **goal):
        super().__init__(what, '-', **goal)
        self.key, self.run_name = key, run_name

    def run(self, context):
        figures = context.node_figures(self.run_name)
        return self.key(figures), json.dumps(figures)


def crfh(dimensions, peer, theirs, **goal):
    name = f'crfh/{dimensions}_dimensions/'
    return Times(f'CRFH, {dimensions} dimensions, 640x480', peer, 'crfh_benchmark', name + 'ours',
                 name + theirs, **goal)


def features(configuration):
    return Times(f'features of `{configuration}`, 640x480', 'its distinct responses, each once',
                 'cues_benchmark', f'{configuration}/features', f'{configuration}/limit', most=1.25)


def answer(configuration, most):
    return Milliseconds(f'answer of `{configuration}`, 1000 vectors in all', 'cues_benchmark',
                        f'{configuration}/answer', most)


ROWS = {
    'crfh': [crfh(6, 'OpenCV, sepFilter2D and sort', 'opencv', least=5),
             crfh(8, 'OpenCV, sepFilter2D and sort', 'opencv', least=5),
             crfh(12, 'OpenCV, sepFilter2D and sort', 'opencv', least=5),
             crfh(6, 'a copy and a multiply-add pass a response', 'limit', most=1.5),
             CrfhGrowth(8), CrfhGrowth(12)],
    'cues': [features('any_light'), features('colour_cues'), features('default'),
             answer('any_light', 2.5), answer('colour_cues', 2), answer('default', 8),
             Milliseconds('features of `mr8`, 640x480', 'cues_benchmark', 'mr8/features', 1000 / 30)],
    'kernel': [Times('chi-squared kernel, a frame with 1000 vectors', 'merging sorted lists',
                     'kernel_benchmark', 'columnOfKernel', 'columnByMerging', least=15),
               Times('decision, 5 rooms, 1000 vectors', 'svm_predict_values, precomputed',
                     'kernel_benchmark', 'decision', 'decisionOfLibsvm', least=15)],
    'local_match': [Rates('local match, 400 descriptors, 500 images', 'nested float loops',
                          'nestedFloatLoops', least=10),
                    Rates('the same, fraction of the peak', 'multiply-adds in registers', 'peak',
                          least=0.5)],
    'local_features': [Times('Harris-Laplace and SIFT, 640x480', 'VLFeat and cv::SIFT',
                             'local_features_benchmark', 'harrisLaplaceSift', 'vlfeatAndOpenCv',
                             least=4)],
    'training': [Training()],
    'reduction': [Times('reduction `qr`, no vector dropped', 'Eigen ColPivHouseholderQR',
                        'reduction_benchmark', 'reduction/none_dropped/ours',
                        'reduction/none_dropped/eigen', least=1),
                  Times('reduction `qr`, tau 0.01 (most dropped)', 'Eigen ColPivHouseholderQR',
                        'reduction_benchmark', 'reduction/default_tau/ours',
                        'reduction/default_tau/eigen', least=3)],
    'model_load': [Times('loading a model of 1000 vectors', 'cat of the file',
                         'model_load_benchmark', 'load', 'cat', most=5)],
    'node': [Node('node, 60 frames a second offered: lost',
                  lambda node: node['offered'] - node['answered'], most=0),
             Node('node, 99th percentile of the latency', lambda node: node['p99_ms'], most=15,
                  unit=' ms'),
             Node('node, fraction of a core', lambda node: node['share_of_core'], most=0.5),
             Node('node, memory', lambda node: node['megabytes'], 'long', most=150, unit=' MB'),
             Node('node, growth of memory over a long run',
                  lambda node: node['growth_megabytes'], 'long', most=2, unit=' MB')],
}
