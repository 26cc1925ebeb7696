#!/usr/bin/env python3
"""Checks kernels, machines, reduction and calibration against numpy and scipy.

learning_check.py LEARNING_DUMP

Exits with 77 (skipped) if numpy or scipy is missing.
"""
import json
import subprocess
import sys

try:
    import numpy as np
    from scipy.linalg import qr, solve_triangular
    from scipy.optimize import minimize_scalar
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)


def as_vectors(features):
    """Returns sparse histograms as the rows of one matrix."""
    if not isinstance(features[0], dict):
        return np.array(features)
    bins = sorted({i for f in features for i in f["indices"]})
    column = {b: k for k, b in enumerate(bins)}
    rows = np.zeros((len(features), len(bins)))
    for row, f in zip(rows, features):
        row[[column[i] for i in f["indices"]]] = f["values"]
    return rows


def local_match(x, y, gamma):
    """Eq. 5.39-5.40."""
    x = np.array(x).reshape(-1, 1, 128) / 512
    y = np.array(y).reshape(1, -1, 128) / 512
    similarity = np.exp(-gamma * ((x - y) ** 2).sum(axis=2))
    return (similarity.max(axis=1).mean() + similarity.max(axis=0).mean()) / 2


def kernel_value(case, x, y):
    gamma = case["gamma"]
    with np.errstate(invalid="ignore"):
        return {
            "linear": lambda: x @ y,
            "polynomial": lambda: (x @ y + case["p"]) ** case["d"],
            "sigmoid": lambda: np.tanh(case["kappa"] * (x @ y) + case["theta"]),
            "gaussian": lambda: np.exp(-gamma * ((x - y) ** 2).sum()),
            "chi-squared": lambda: np.exp(-gamma * np.nansum((x - y) ** 2 / (x + y))),
            "intersection": lambda: np.minimum(x, y).sum(),
            "local-match": lambda: local_match(x, y, gamma),
        }[case["type"]]()


def check_kernel(case):
    local = case["type"] == "local-match"
    features = case["features"] if local else as_vectors(case["features"])
    expected = [[kernel_value(case, x, y) for y in features] for x in features]
    np.testing.assert_allclose(case["gram"], expected, rtol=0, atol=1e-12)


def check_machines(case):
    """Checks that the duality gap is almost zero, so both solutions are optimal."""
    gram, weights = np.array(case["gram"]), np.array(case["weights"])
    for place, (a, bias) in enumerate(zip(weights.T, case["biases"][0])):
        signs = np.where(np.array(case["labels"]) == place, 1, -1)
        alpha = signs * a
        assert abs(a.sum()) < 1e-9 and alpha.min() >= 0 and alpha.max() <= case["c"] * (1 + 1e-12)
        primal = a @ gram @ a / 2 + case["c"] * np.maximum(0, 1 - signs * (gram @ a + bias)).sum()
        dual = alpha.sum() - a @ gram @ a / 2
        assert 0 <= primal - dual < 1e-2 * primal, (primal, dual)


def thesis_reduction(gram, alpha, tau, normalize):
    """Eq. 6.19-6.21 for one machine."""
    vectors = np.flatnonzero(alpha)
    k = gram[:, vectors]
    scales = np.linalg.norm(k, axis=0) if normalize else np.ones(len(vectors))
    scales[0] *= 1 - 1e-9 * normalize  # the first of equal norms is the first pivot
    _, r, order = qr(k / scales, mode="economic", pivoting=True)
    rank = int((np.abs(np.diag(r)) > tau * abs(r[0, 0])).sum())
    scaled = (alpha[vectors] * scales)[order]
    updated = scaled[:rank] + solve_triangular(r[:rank, :rank], r[:rank, rank:] @ scaled[rank:])
    reduced = np.zeros_like(alpha)
    reduced[vectors[order[:rank]]] = updated / scales[order[:rank]]
    return reduced


def pivots_of_all(gram, weights, tau, normalize):
    vectors = np.flatnonzero(weights.any(axis=1))
    k = gram[:, vectors]
    scales = np.linalg.norm(k, axis=0) if normalize else np.ones(len(vectors))
    scales[0] *= 1 - 1e-9 * normalize
    _, r, order = qr(k / scales, mode="economic", pivoting=True)
    return vectors[order[np.abs(np.diag(r)) > tau * abs(r[0, 0])]]


def greedy_basis(gram, weights, tau, _):
    """The greedy reduction, which tries every vector at every step."""
    vectors = list(np.flatnonzero(weights.any(axis=1)))
    values = gram @ weights
    basis = []

    def gap(columns):
        fit = np.linalg.lstsq(gram[:, columns], values, rcond=None)[0]
        return np.linalg.norm(values - gram[:, columns] @ fit)

    while not basis or gap(basis) > tau * np.linalg.norm(values):
        basis.append(min((v for v in vectors if v not in basis), key=lambda v: gap(basis + [v])))
    return np.array(basis)


def check_reduction(case):
    gram, weights, reduced = (np.array(case[key]) for key in ("gram", "weights", "reduced"))
    tau, normalize = case["tau"], case["normalize"]
    if case["method"] == "qr":
        expected = np.stack([thesis_reduction(gram, a, tau, normalize) for a in weights.T], axis=1)
    else:
        choose = pivots_of_all if case["method"] == "shared-qr" else greedy_basis
        basis = choose(gram, weights, tau, normalize)
        expected = np.zeros_like(weights)
        expected[basis] = np.linalg.lstsq(gram[:, basis], gram @ weights, rcond=None)[0]
    assert (expected.any(axis=1) == reduced.any(axis=1)).all(), "other vectors are kept"
    assert reduced.any(axis=1).sum() < weights.any(axis=1).sum()
    np.testing.assert_allclose(gram @ reduced, gram @ expected, rtol=0,
                               atol=1e-7 * np.abs(gram @ weights).max())


def check_calibration(case):
    values, labels = np.array(case["decision_values"]), np.array(case["labels"])
    frames, places = values.shape
    wanted = np.full(values.shape, 1 / (places * (frames + 1)))  # one frame contains no information
    wanted[np.arange(frames), labels] += frames / (frames + 1)

    def loss(slope):
        z = slope * values
        return -(wanted * (z - np.log(np.exp(z).sum(axis=1, keepdims=True)))).sum()

    expected = minimize_scalar(loss, bounds=(0, 100), method="bounded", options={"xatol": 1e-9}).x
    np.testing.assert_allclose(case["slope"], expected, rtol=1e-6)


def main():
    checks = {"kernel": check_kernel, "machines": check_machines, "reduction": check_reduction,
              "calibration": check_calibration}
    lines = subprocess.run([sys.argv[1]], check=True, stdout=subprocess.PIPE).stdout.splitlines()
    for line in lines:
        case = json.loads(line)
        checks[case["check"]](case)
        print("ok:", *(f"{key} {case[key]}" for key in ("check", "type", "method", "tau",
                                                        "normalize") if key in case))
    assert len(lines) == 13 + 1 + 12 + 1


if __name__ == "__main__":
    main()
