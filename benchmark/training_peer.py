#!/usr/bin/env python3
"""The same training as training_benchmark, with numpy, scipy and scikit-learn.

usage: training_peer.py FOLDER    after `training_benchmark run FOLDER`

Prints processor seconds; reports and exits with 1 if the results differ.
"""
import sys
import time

import numpy as np
import scipy.optimize
import scipy.sparse
from sklearn.svm import SVC

GAMMA, C, FOLDS, PLACES = 1.0, 100.0, 5, 5
TOLERANCE = 0.01  # of decision values: both solvers stop at 1e-4 of their conditions


def read_features(folder):
    indices = np.fromfile(folder + '/indices', np.uint64)
    sizes = np.fromfile(folder + '/sizes', np.uint64).astype(np.int64)
    values = np.fromfile(folder + '/values', np.float32).astype(float)
    columns = np.unique(indices, return_inverse=True)[1]
    return scipy.sparse.csr_matrix((values, columns, np.concatenate([[0], np.cumsum(sizes)])))


def chi_squared_distances(features):
    """Compares each row with those after it."""
    count = features.shape[0]
    totals = np.asarray(features.sum(axis=1)).ravel()
    distances = np.zeros((count, count))
    row = np.zeros(features.shape[1])
    for i in range(count):
        begin, end = features.indptr[i], features.indptr[i + 1]
        row[features.indices[begin:end]] = features.data[begin:end]
        theirs = features.data[begin:]
        ours = row[features.indices[begin:]]
        shared = np.add.reduceat(ours * theirs / (ours + theirs), features.indptr[i:-1] - begin)
        distances[i, i:] = distances[i:, i] = totals[i] + totals[i:] - 4 * shared
        row[features.indices[begin:end]] = 0
    return np.maximum(distances, 0)


def decision_values(gram, labels, train, test):
    values = np.empty((len(test), PLACES))
    for place in range(PLACES):
        machine = SVC(C=C, kernel='precomputed', tol=1e-4)
        machine.fit(gram[np.ix_(train, train)], labels[train] == place)
        values[:, place] = machine.decision_function(gram[np.ix_(test, train)])
    return values


def fit_slope(values, labels):
    """The slope of largest likelihood for softmax(slope * values), with smoothed targets."""
    count = len(labels)
    wanted = np.full(values.shape, 1 / PLACES / (count + 1))
    wanted[np.arange(count), labels] += count / (count + 1)

    def loss(log_slope):
        scores = np.exp(log_slope) * values
        largest = scores.max(axis=1, keepdims=True)
        log_sums = largest + np.log(np.exp(scores - largest).sum(axis=1, keepdims=True))
        return -(wanted * (scores - log_sums)).sum()
    return np.exp(scipy.optimize.minimize_scalar(loss, bounds=(-7, 10), method='bounded').x)


def main(folder):
    features = read_features(folder)
    labels = np.fromfile(folder + '/labels', np.int32)
    count = len(labels)
    everything = np.arange(count)

    start = time.process_time()
    gram = np.exp(-GAMMA * chi_squared_distances(features))
    held_out = np.empty((count, PLACES))
    for fold in range(FOLDS):
        test = np.arange(fold * count // FOLDS, (fold + 1) * count // FOLDS)
        held_out[test] = decision_values(gram, labels, np.setdiff1d(everything, test), test)
    slope = fit_slope(held_out, labels)
    values = decision_values(gram, labels, everything, everything)
    print(time.process_time() - start)

    theirs = np.fromfile(folder + '/decision_values').reshape(PLACES, count).T
    their_slope = np.fromfile(folder + '/slope')[0]
    if np.abs(theirs - values).max() > TOLERANCE or abs(their_slope / slope - 1) > TOLERANCE:
        sys.exit(f'The decision values differ by {np.abs(theirs - values).max():.3g}, the slopes are '
                 f'{their_slope:.4g} and {slope:.4g}.')


if __name__ == '__main__':
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
