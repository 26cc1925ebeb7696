#!/usr/bin/env python3
"""Checks MR8 against an independent computation with numpy and scipy.

mr8_check.py MR8_DUMP DATA_FOLDER

Filters must agree to within 1e-6 of their largest value. Fewer than 0.1 % of the pixels, those
within float rounding of a level, may fall in another bin than here. Exits with 77 (skipped) if the
images are missing.
"""
import collections
import glob
import os
import subprocess
import sys

import cv2
import numpy as np
from scipy.signal import fftconvolve

SIDE, BINS, RANGE = 49, 4, 1.0


def normalized(f, zero_mean=True):
    f = f - f.mean() if zero_mean else f
    return f / np.abs(f).sum()


def filters():
    """Returns six edges and six bars at each scale, the Gaussian, and the Laplacian of Gaussian."""
    y, x = np.mgrid[:SIDE, :SIDE] - SIDE // 2
    bank = []
    for s in (1, 2, 4):
        edges, bars = [], []
        for angle in np.arange(6) * np.pi / 6:
            u, v = x * np.cos(angle) + y * np.sin(angle), y * np.cos(angle) - x * np.sin(angle)
            envelope = np.exp(-u ** 2 / (18 * s * s) - v ** 2 / (2 * s * s))
            edges.append(normalized(-v * envelope))
            bars.append(normalized((v ** 2 - s * s) * envelope))
        bank += edges + bars
    square = x ** 2 + y ** 2
    gaussian = np.exp(-square / 200)
    return bank + [normalized(gaussian, False), normalized((square - 200) * gaussian)]


def bins(image):
    image = (image - image.mean()) / image.std()
    padded = np.pad(image, SIDE // 2, mode="reflect")
    r = [fftconvolve(padded, f, mode="valid") for f in filters()]
    best = [np.abs(r[12 * s + 6 * kind:][:6]).max(axis=0) for kind in (0, 1) for s in range(3)]
    responses = np.array(best + r[-2:])
    norm = np.sqrt((responses ** 2).sum(axis=0))
    responses *= np.log(1 + norm / 0.03) / norm
    share = responses / RANGE
    share[6:] = (share[6:] + 1) / 2
    digits = np.clip(np.floor(share * BINS), 0, BINS - 1).astype(int)
    return (digits * (BINS ** np.arange(8))[:, None, None]).sum(axis=0)


def run(dump, argument):
    return subprocess.run([dump, argument], check=True, capture_output=True, text=True).stdout


def main():
    dump, data = sys.argv[1:]
    failures = 0
    measured = [np.array(line.split(), float) for line in run(dump, "filters").splitlines()]
    expected = filters()
    assert len(measured) == len(expected) == 38
    for i, (m, e) in enumerate(zip(measured, expected)):
        if np.abs(m - e.ravel()).max() > 1e-6 * np.abs(e).max():
            print("FAILED: filter %d" % i)
            failures += 1
    pictures = sorted(glob.glob(os.path.join(data, "floor_materials/*/*.jpg")))[40::100]
    if not pictures:
        print("no images in " + data + ": skipped")
        return 1 if failures else 77
    for picture in pictures:
        index = bins(cv2.imread(picture, cv2.IMREAD_GRAYSCALE).astype(float)).ravel()
        expected = collections.Counter(index)
        measured = {int(i): float(v) for i, v in
                    (line.split(":") for line in run(dump, picture).split())}
        moved = sum(abs(expected.get(i, 0) / len(index) - measured.get(i, 0))
                    for i in set(expected) | set(measured)) / 2
        verdict = "" if moved < 1e-3 else "FAILED: "
        failures += verdict != ""
        print("%s%s: %d bins, %.4f %% of the pixels in another" % (
            verdict, os.path.basename(picture), len(measured), 100 * moved), flush=True)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
