#!/usr/bin/env python3
"""Checks CRFH against an independent computation in double precision with scipy.

crfh_check.py CRFH_DUMP DATA_FOLDER

The histogram must have the same bins and values, except for pixels whose responses are within float
rounding of a bin edge: each of these may be in the bin on either side, and fewer than 0.1 % of the
pixels may be in another bin than here. Exits with 77 (skipped) if images or packages are missing.
"""
import collections
import glob
import itertools
import os
import subprocess
import sys

try:
    import cv2
    import numpy as np
    from scipy.ndimage import correlate1d
except ImportError as missing:
    print("%s: skipped; install python3-numpy, python3-scipy and python3-opencv" % missing)
    sys.exit(77)

CASES = {
    "thesis": {},
    "first derivatives": {"descriptors": ["Lx", "Ly"], "scales": [1, 4, 16]},
    "all operators": {"descriptors": ["L", "Lx", "Ly", "Lxx", "Lxy", "Lyy", "grad(L)", "lap(L)",
                                      "det(L)"], "scales": [2], "bins": [16]},
    "two scales of all derivatives": {"descriptors": ["Lx", "Ly", "Lxx", "Lxy", "Lyy"]},
    "colour": {"descriptors": ["R", "G", "B", "C1", "C2"], "scales": [1, 5], "bins": [9]},
    "derivatives of colour": {"descriptors": ["Rx", "Gyy", "det(B)", "C1xy", "grad(C2)"],
                              "scales": [3], "bins": [11, 28, 7, 32, 64]},
    "gaussian derivatives": {"derivatives": "gaussian"},
    "gaussian derivatives of colour": {"descriptors": ["C2x", "lap(R)", "Gxy", "Ly"],
                                       "derivatives": "gaussian", "scales": [2.5]},
    "odd bins": {"bins": [27], "derivative_range": 100},
    "large scales": {"scales": [25, 100]},
    "another kernel and border": {"half_width": 4, "border": 0},
}
DEFAULTS = {"descriptors": ["Lxx", "Lxy", "Lyy"], "scales": [1, 4], "bins": [28],
            "derivatives": "central-difference", "derivative_range": 128, "half_width": 3,
            "border": 15}

# Rounding of a float response, in grey levels, before it is multiplied by the scale.
ROUNDING = 255 * 2.0 ** -22


def kernels(t, half):
    """Returns the Gaussian and its first two derivatives as correlation kernels that are exact for
    parabolas."""
    x = np.arange(-half, half + 1)
    g = np.exp(-x ** 2 / (2 * t))
    g /= g.sum()
    first = x * g
    second = (x ** 2 - (x ** 2 * g).sum()) * g
    return g, first / (x * first).sum(), second * 2 / (x ** 2 * second).sum()


def jet(plane, t, options):
    """Returns a function that computes the derivative of given orders in x and y."""
    half = max(int(np.ceil(options["half_width"] * np.sqrt(t))), 1)
    gaussian = kernels(t, half)
    if options["derivatives"] == "gaussian":
        return lambda dx, dy: correlate1d(correlate1d(plane, gaussian[dx], 1), gaussian[dy], 0)
    smooth = correlate1d(correlate1d(plane, gaussian[0], 0), gaussian[0], 1)
    stencils = [np.array([1.0]), np.array([-0.5, 0, 0.5]), np.array([1.0, -2, 1])]
    return lambda dx, dy: correlate1d(correlate1d(smooth, stencils[dx], 1), stencils[dy], 0)


def channel(image, name):
    b, g, r = (image[..., i].astype(float) for i in range(3))
    return {"L": (r + g + b) / 3, "R": r, "G": g, "B": b,
            "C1": (r - g) / 2, "C2": (r + g) / 2 - b}[name]


def response(image, descriptor, t, options):
    """Returns the normalized response and its range."""
    limit = options["derivative_range"]
    if descriptor.endswith(")"):
        function, name = descriptor[:-1].split("(")
        d = jet(channel(image, name), t, options)
        if function == "grad":
            return np.sqrt(t * (d(1, 0) ** 2 + d(0, 1) ** 2)), 0, limit
        if function == "lap":
            return t * (d(2, 0) + d(0, 2)), -limit, limit
        return t ** 2 * (d(2, 0) * d(0, 2) - d(1, 1) ** 2), -limit / 4, limit / 4
    name = descriptor.rstrip("xy")
    suffix = descriptor[len(name):]
    value = jet(channel(image, name), t, options)(suffix.count("x"), suffix.count("y"))
    if suffix:
        return t ** (len(suffix) / 2) * value, -limit, limit
    return value, *{"C1": (-127.5, 127.5), "C2": (-255, 255)}.get(name, (0, 255))


def digits(image, options):
    """Returns, for each dimension, the digit of every counted pixel, the digits that rounding could
    give it, and the number of bins."""
    half = max(int(np.ceil(options["half_width"] * np.sqrt(max(options["scales"])))), 1)
    border = max(options["border"], half + 1)
    inside = (slice(border, -border),) * 2
    for t in options["scales"]:
        for i, descriptor in enumerate(options["descriptors"]):
            bins = options["bins"][i if len(options["bins"]) > 1 else 0]
            value, low, high = response(image, descriptor, t, options)
            # The determinant is a product of two responses: its error grows with their size.
            size = np.sqrt(np.abs(value)).max() + 128 if descriptor[:3] == "det" else 1
            error = ROUNDING * max(t, 1) * size
            level = lambda v: np.clip(np.floor(np.round((v - low) * bins / (high - low), 12)),
                                      0, bins - 1).astype(np.uint64)[inside].ravel()
            yield level(value), level(value - error), level(value + error), bins


def count(indices):
    return collections.Counter(dict(zip(*(a.tolist() for a in
                                          np.unique(indices, return_counts=True)))))


def check(image, measured, options):
    """Returns the number of counted pixels and the number of them in another bin than here."""
    index, weight = np.uint64(0), 1
    unsure = []  # Possible change of the index by rounding, modulo 2^64.
    for here, below, above, bins in digits(image, options):
        index = index + here * np.uint64(weight)
        unsure.append(((below - here) * np.uint64(weight), (above - here) * np.uint64(weight)))
        weight *= bins
    ambiguous = np.any([(a != 0) | (b != 0) for a, b in unsure], axis=0)

    total = len(index)
    counts = collections.Counter({i: round(v * total) for i, v in measured.items()})
    assert list(measured) == sorted(measured), "indices are not ascending"
    assert all(abs(counts[i] / total - v) < 1e-6 for i, v in measured.items()), "not whole counts"
    assert sum(counts.values()) == total, "does not sum to 1"

    certain = count(index[~ambiguous])
    assert not certain - counts, "%d pixels are in a wrong bin" % sum((certain - counts).values())
    possible = set()
    for pixel in np.flatnonzero(ambiguous):
        steps = [{0, int(a[pixel]), int(b[pixel])} for a, b in unsure]
        possible.update((int(index[pixel]) + sum(choice)) % 2 ** 64
                        for choice in itertools.product(*steps))
    wrong = set(counts - certain) - possible
    assert not wrong, "%d bins that no pixel can be in" % len(wrong)
    return total, sum((counts - count(index)).values())


def main():
    dump, data = sys.argv[1:]
    rooms = sorted(glob.glob(os.path.join(data, "ie_rooms/clip1/*")))
    pictures = [sorted(glob.glob(room + "/*.jpg"))[0] for room in rooms[::4]]
    pictures += sorted(glob.glob(os.path.join(data, "nao_canteen/run*/canteen/*.jpg")))[50::150]
    if not pictures:
        print("no images in " + data + ": skipped")
        return 77
    failures = 0
    for name, case in CASES.items():
        for picture in pictures:
            text = "{" + ", ".join("%s: %s" % (k, str(v).replace("'", "")) for k, v in
                                   case.items()) + "}"
            output = subprocess.run([dump, picture, text], check=True, capture_output=True,
                                    text=True).stdout
            measured = {int(i): float(v) for i, v in (line.split(":") for line in output.split())}
            try:
                total, moved = check(cv2.imread(picture), measured, {**DEFAULTS, **case})
                assert moved < 1e-3 * total, "%d of %d pixels moved" % (moved, total)
                verdict = "%d bins, %d of %d pixels beyond a bin edge" % (len(measured), moved, total)
            except AssertionError as error:
                verdict = "FAILED: %s" % error
                failures += 1
            print("%s, %s: %s" % (name, os.path.basename(picture), verdict), flush=True)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
