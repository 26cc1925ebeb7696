#!/usr/bin/env python3
"""Checks the embeddings of a network built here against an independent computation with numpy.

embedding_check.py EMBEDDING_DUMP

Values must agree to within 1e-5. Exits with 77 (skipped) if python3-onnx is missing.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import cv2
import numpy as np

try:
    import onnx
    from onnx import TensorProto, helper, numpy_helper
except ImportError:
    print("python3-onnx is not installed: skipped")
    sys.exit(77)

WIDTH, HEIGHT = 24, 20
RANDOM = np.random.default_rng(20)


def weights(*shape):
    return (RANDOM.normal(size=shape) / np.sqrt(np.prod(shape[1:]))).astype(np.float32)


def build(channels, w):
    """Convolution (3 x 3, stride 2, padding 1), ReLU, clipped depthwise convolution with stride 2,
    1 x 1."""
    nodes = [
        helper.make_node("Conv", ["image", "w1", "b1"], ["c1"], "first", strides=[2, 2],
                         pads=[1, 1, 1, 1], kernel_shape=[3, 3]),
        helper.make_node("Relu", ["c1"], ["r1"], "rectified"),
        helper.make_node("Conv", ["r1", "w2", "b2"], ["c2"], "depthwise", group=8, strides=[2, 2],
                         pads=[1, 1, 1, 1], kernel_shape=[3, 3]),
        helper.make_node("Clip", ["c2"], ["k2"], "clipped", min=-0.5, max=0.5),
        helper.make_node("Conv", ["k2", "w3", "b3"], ["map"], "last", kernel_shape=[1, 1]),
        helper.make_node("GlobalAveragePool", ["map"], ["mean"], "pooled"),
        helper.make_node("Flatten", ["mean"], ["flat"], "flattened"),
        helper.make_node("Gemm", ["flat", "w4", "b4"], ["scores"], "classes", transB=1),
    ]
    graph = helper.make_graph(
        nodes, "checked",
        [helper.make_tensor_value_info("image", TensorProto.FLOAT, [1, channels, HEIGHT, WIDTH])],
        [helper.make_tensor_value_info("scores", TensorProto.FLOAT, [1, 5])],
        [numpy_helper.from_array(value, name) for name, value in w.items()])
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 9)])
    model.ir_version = 6
    onnx.checker.check_model(model)
    return model.SerializeToString()


def convolve(x, w, b, stride=1, padding=0, group=1):
    x = np.pad(x, ((0, 0), (padding, padding), (padding, padding)))
    side = w.shape[2]
    rows = (x.shape[1] - side) // stride + 1
    columns = (x.shape[2] - side) // stride + 1
    y = np.zeros((w.shape[0], rows, columns))
    inputs = x.shape[0] // group
    outputs = w.shape[0] // group
    for o in range(w.shape[0]):
        part = x[o // outputs * inputs:][:inputs]
        for r in range(rows):
            for c in range(columns):
                y[o, r, c] = (part[:, r * stride:r * stride + side, c * stride:c * stride + side]
                              * w[o]).sum() + b[o]
    return y


def expected(blob, w, layer, stride):
    x = np.maximum(convolve(blob, w["w1"], w["b1"], 2, 1), 0)
    if layer == "rectified" or stride == 2:
        return x
    x = np.clip(convolve(x, w["w2"], w["b2"], 2, 1, 8), -0.5, 0.5)
    x = convolve(x, w["w3"], w["b3"])
    if layer in ("map", "last", "pooled", "flat"):
        return x
    return w["w4"] @ x.mean(axis=(1, 2)) + w["b4"]


def unit(vector):
    return vector / np.linalg.norm(vector)


def generalized_mean(x, power):
    if power == 1:
        return x.mean(axis=(1, 2))
    return (np.maximum(x, 0) ** power).mean(axis=(1, 2)) ** (1 / power)


def averages(x, columns, power):
    """The whole; with several columns each of them, too, which together have the same norm."""
    whole = unit(generalized_mean(x, power))
    if columns == 1:
        return whole
    edges = [x.shape[2] * c // columns for c in range(columns + 1)]
    parts = [unit(generalized_mean(x[:, :, a:b], power)) for a, b in zip(edges, edges[1:])]
    return unit(np.concatenate([whole] + [part / np.sqrt(columns) for part in parts]))


def blob_of(image, options):
    """Returns the image's planes as the network's input; averages 2 x 2 pixels if it is twice as
    large."""
    if options.get("fit") == "crop":  # removes 8 columns at each side of the images below
        image = image[:, 8:-8]
    if image.shape[0] == 2 * HEIGHT:
        sums = image.astype(int).reshape(HEIGHT, 2, WIDTH, 2, -1).sum(axis=(1, 3))
        image = np.squeeze((sums + 2) // 4)
    if options["channels"] == "grey":
        planes = image[None].astype(float)
    elif image.ndim == 2:
        planes = np.array([image] * 3, float)
    else:
        planes = image.transpose(2, 0, 1).astype(float)
        planes = planes[::-1] if options["channels"] == "rgb" else planes
    column = lambda numbers: np.array(numbers, float)[:, None, None]
    return (planes - column(options["mean"])) * column(options["scale"])


def main():
    dump = sys.argv[1]
    failures = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        w = {"w1": weights(8, 3, 3, 3), "b1": weights(8), "w2": weights(8, 1, 3, 3),
             "b2": weights(8), "w3": weights(12, 8, 1, 1), "b3": weights(12),
             "w4": weights(5, 12), "b4": weights(5)}
        of_grey = dict(w, w1=weights(8, 1, 3, 3))
        (folder / "colour.onnx").write_bytes(build(3, w))
        (folder / "grey.onnx").write_bytes(build(1, of_grey))
        noise = RANDOM.integers(0, 256, (2 * HEIGHT, 2 * WIDTH, 3)).astype(np.uint8)
        wide = RANDOM.integers(0, 256, (2 * HEIGHT, 2 * WIDTH + 16, 3)).astype(np.uint8)
        small = noise[:HEIGHT, :WIDTH]
        plain = {"mean": [127.5], "scale": [1 / 127.5], "channels": "rgb"}
        each = {"mean": [123.7, 116.3, 103.5], "scale": [0.0171, 0.0175, -0.0174]}
        for image, layer, options in (
                (small, "", plain), (small, "rectified", plain), (small, "map", plain),
                (small, "last", plain), (small, "pooled", plain), (small, "flat", plain),
                (noise, "map", plain), (wide, "map", dict(plain, fit="crop")),
                (small, "scores", dict(plain, channels="bgr")),
                (small, "map", dict(plain, **each)),
                (small, "flat", dict(plain, columns=3)), (small, "map", dict(plain, columns=4)),
                (noise, "rectified", dict(plain, columns=5)),
                (small, "map", dict(plain, stride=2)), (small, "", dict(plain, stride=2, power=3)),
                (small, "map", dict(plain, stride=4, power=2)),
                (noise, "", dict(plain, stride=2, power=8, columns=5)),
                (small[:, :, 0], "map", plain), (small[:, :, 0], "map", dict(plain, channels="grey")),
                (noise[:, :, 1], "", dict(plain, channels="grey"))):
            is_grey = options["channels"] == "grey"
            network = folder / ("grey.onnx" if is_grey else "colour.onnx")
            (folder / "options.yaml").write_text(
                json.dumps(dict(options, network=str(network), layer=layer)))
            cv2.imwrite(str(folder / "a.png"), image)
            out = subprocess.run([dump, folder / "options.yaml", folder / "a.png"], check=True,
                                 stdout=subprocess.PIPE, universal_newlines=True).stdout
            measured = np.array(out.split(), float)
            vector = expected(blob_of(image, options), of_grey if is_grey else w, layer,
                              options.get("stride", 0))
            how = options.get("columns", 1), options.get("power", 1)
            vector = averages(vector, *how) if vector.ndim == 3 else unit(vector)
            error = np.abs(measured - vector).max() if measured.shape == vector.shape else np.inf
            failed = not error < 1e-5
            failures += failed
            print(f"{'FAILED: ' if failed else ''}layer '{layer}', {image.shape}, {options}: "
                  f"{len(measured)} values, error {error:.1e}", flush=True)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
