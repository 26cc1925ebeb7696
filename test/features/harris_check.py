#!/usr/bin/env python3
"""Checks Harris-Laplace points against an independent computation with scipy.

harris_check.py HARRIS_DUMP DATA_FOLDER

One octave of section 4.3.1 of the thesis: sigma_I from 2 in steps of a quarter octave, sigma_D =
sigma_I / sqrt(2). Each scale is smoothed directly from the image, in double precision, and the
Laplacian is interpolated by a spline. Corners must have the same position and cornerness. 6 % may
differ in the existence or scale of the Laplacian's extremum, which depends on the interpolation if
the Laplacian hardly changes. Exits with 77 (skipped) if the images are missing.
"""
import glob
import os
import subprocess
import sys

import cv2
import numpy as np
from scipy.ndimage import correlate1d, gaussian_filter, map_coordinates, maximum_filter, spline_filter

STEPS, ALPHA, CORNERNESS, LAPLACIAN, BORDER = 4, 0.05, 100, 5, 4


def sigma(n):
    """Returns the sigma of scale n: 0 is the first differentiation scale, 2 the first integration
    scale."""
    return 2 / np.sqrt(2) * 2 ** (n / STEPS)


def blur(image, s, half_width):
    return gaussian_filter(image, s, truncate=np.ceil(half_width * s) / s, mode="mirror")  # its radius


def peak(before, middle, after):
    curvature = before - 2 * middle + after
    return np.clip(0.5 * (before - after) / curvature, -0.5, 0.5) if curvature < 0 else 0


def detect(image):
    levels = [blur(image, np.sqrt(sigma(n) ** 2 - 0.25), 5) for n in range(STEPS + STEPS // 2)]
    second = np.array([2, -27, 270, -490, 270, -27, 2]) / 180
    splines = [sigma(n) ** 2 * spline_filter(correlate1d(level, second, 0, mode="mirror") +
                                             correlate1d(level, second, 1, mode="mirror"), order=5)
               for n, level in enumerate(levels)]
    points = []
    for n in range(STEPS):
        dx = correlate1d(levels[n], [-0.5, 0, 0.5], 1, mode="mirror")
        dy = correlate1d(levels[n], [-0.5, 0, 0.5], 0, mode="mirror")
        xx, xy, yy = (sigma(n) ** 2 * blur(p, sigma(n + STEPS // 2), 3)
                      for p in (dx * dx, dx * dy, dy * dy))
        c = xx * yy - xy ** 2 - ALPHA * (xx + yy) ** 2
        is_peak = (c == maximum_filter(c, 3)) & (c > CORNERNESS)
        for y, x in np.argwhere(is_peak[BORDER:-BORDER, BORDER:-BORDER]) + BORDER:
            px = x + peak(c[y, x - 1], c[y, x], c[y, x + 1])
            py = y + peak(c[y - 1, x], c[y, x], c[y + 1, x])
            m = [abs(map_coordinates(s, [[py], [px]], order=5, mode="mirror", prefilter=False)[0])
                 for s in splines]
            middle = n + STEPS // 2
            for k in range(max(middle - STEPS, STEPS // 2), min(middle + STEPS, len(m) - 2) + 1):
                if m[k] >= LAPLACIAN and m[k] > m[k - 1] and m[k] >= m[k + 1]:
                    points.append((px, py, sigma(k + peak(m[k - 1], m[k], m[k + 1])), c[y, x]))
    kept = []
    for p in sorted(points, key=lambda p: (-p[3], p[2], p[1], p[0])):
        if not any(np.hypot(p[0] - q[0], p[1] - q[1]) < min(p[2], q[2]) and
                   max(p[2], q[2]) < 1.3 * min(p[2], q[2]) for q in kept):
            kept.append(p)
    return np.array(kept)


def share(points, others):
    """Returns the fraction of points that are also among the others."""
    return np.mean([np.any((np.hypot(others[:, 0] - x, others[:, 1] - y) < 0.01) &
                           (np.abs(others[:, 2] / s - 1) < 0.05) &
                           (np.abs(others[:, 3] / c - 1) < 0.001)) for x, y, s, c in points])


def main():
    dump, data = sys.argv[1:]
    pictures = sorted(glob.glob(os.path.join(data, "ie_rooms/clip2/*/*.jpg")))[10::40]
    if not pictures:
        print("no images in " + data + ": skipped")
        return 77
    failures = 0
    for picture in pictures:
        output = subprocess.run([dump, picture], check=True, capture_output=True, text=True).stdout
        measured = np.array([[float(v) for v in line.split()] for line in output.splitlines()])
        expected = detect(cv2.imread(picture, cv2.IMREAD_GRAYSCALE).astype(float))
        both = min(share(measured, expected), share(expected, measured))
        verdict = "" if both > 0.94 else "FAILED: "
        failures += verdict != ""
        print("%s%s: %d points, scipy's %d; %.1f %% agree" % (
            verdict, os.path.basename(picture), len(measured), len(expected), 100 * both), flush=True)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
