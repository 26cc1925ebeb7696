"""Measures how costs grow with growth_benchmark and training_growth; fits and plots exponents."""
import json
import math

from measure import Failed, call
from rows import row

TRAINING_FRAMES = (500, 1000, 2000, 5000, 10000, 20000)
# What grows: its name, the exponent with which it must grow, and the quantity it is a power of.
PANELS = {
    'imageSize': ('height of the image, pixels (4:3)', 2),
    'dimensions': ('dimensions of the histogram', 1),
    'bins': ('bins of each of 6 dimensions', 1),
    'supportVectors': ('support vectors', 1),
    'rooms': ('rooms', 1),
}
TRAINING = {
    'processor_seconds': ('training: processor time', 's', 2),
    'megabytes': ('training: memory', 'MB', 2),
}
ALLOWANCE = 0.1  # of an exponent: constant parts, caches and noise


def exponent(points):
    """The steepest line through three neighbouring points on logarithmic scales."""
    slopes = [math.log(c[1] / a[1]) / math.log(c[0] / a[0])
              for a, c in zip(points, points[2:])]
    return max(slopes)


def curves(programs):
    points = {}
    for name in programs.names('growth_benchmark'):
        kind, x = name.split('/')[:2]
        time = programs.milliseconds('growth_benchmark', name)
        points.setdefault(kind, []).append((int(x), time))
    return {kind: sorted(curve) for kind, curve in points.items()}  # they ran in any order


def training_curve(programs, most_frames):
    """Training from images to a model, with the search for gamma and reduction of the default."""
    return [json.loads(call([programs.path('training_growth'), frames], env=programs.environment))
            for frames in TRAINING_FRAMES if frames <= most_frames]


def growth_row(what, points, power):
    figure = exponent(points)
    return row(f'growth with {what}', '-', f'power {power} at most', figure,
               figure <= power + ALLOWANCE,
               ', '.join(f'{x:g}: {y:.3g}' for x, y in points))


def measure_growth(programs, most_frames):
    """Rows for the table, and their points."""
    rows, points = [], {}
    try:
        points = curves(programs)
        for kind, (what, power) in PANELS.items():
            rows.append(growth_row(what + ' (ms)', points[kind], power))
        training = training_curve(programs, most_frames)
        for key, (what, unit, power) in TRAINING.items():
            points[key] = [(run['frames'], run[key]) for run in training]
            if len(training) >= 3:
                rows.append(growth_row(f'training frames, {what} ({unit})', points[key], power))
    except Failed as failure:
        rows.append(row('growth', '-', '-', None, False, str(failure)))
    return rows, points


def draw(points, path):
    import matplotlib
    matplotlib.use('svg')
    from matplotlib import pyplot
    matplotlib.rcParams['svg.hashsalt'] = 'growth'  # the same bytes for the same points

    figure, axes = pyplot.subplots(2, 4, figsize=(13, 6), layout='constrained')
    titles = {kind: (what, 'ms') for kind, (what, _) in PANELS.items()}
    titles.update({kind: ('frames trained on', what.split(': ')[1] + f', {unit}')
                   for kind, (what, unit, _) in TRAINING.items()})
    for axis in axes.flat[len(points):]:
        axis.set_axis_off()
    for axis, (kind, curve) in zip(axes.flat, points.items()):
        x, y = zip(*curve)
        axis.loglog(x, y, 'o-', color='tab:blue')
        axis.set_xticks(x, [f'{value:g}' for value in x], rotation=45)
        axis.minorticks_off()
        axis.set_xlabel(titles[kind][0])
        axis.set_ylabel(titles[kind][1])
        axis.set_ylim(min(y) / 2, max(y) * 2)
        axis.grid(True, alpha=0.3)
    figure.savefig(path, metadata={'Date': None})
