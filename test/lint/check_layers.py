"""Checks that the dependencies between the folders of src/ point in one direction.

The table of folders in doc/design.md defines the rules: a source may include the public headers,
its own folder, and the folders and libraries that its row of the table names. Folders inside a
layer are ordered in the same way, and CMake targets link only what the table names. Public headers
may use types of src/ only in private members.
"""
import pathlib
import re
import sys

# The table's names of libraries, and the first components of their includes.
LIBRARIES = {
    "Eigen": {"Eigen"},
    "ICU": {"unicode"},
    "libjpeg": {"jpeglib.h"},
    "libsvm": {"libsvm", "svm.h"},
    "nlohmann_json": {"nlohmann"},
    "OpenCV": {"opencv2"},
    "OpenSSL": {"openssl"},
    "Boost": {"boost"},
    "protobuf": {"google"},
    "ROS": {"ros", "sensor_msgs", "std_msgs", "std_srvs", "cv_bridge", "rosbag", "image_transport",
            "actionlib", "nodelet", "diagnostic_updater", "dynamic_reconfigure", "pluginlib",
            "tf2_ros", "nav_msgs", "visualization_msgs", "geometry_msgs", "xmlrpcpp"},
    "yaml-cpp": {"yaml-cpp"},
    "zlib": {"zlib.h"},
}
ROW = re.compile(r"^\| `src/(\w+)/` \| .* \| (.*) \|$", re.MULTILINE)
SUBFOLDERS = re.compile(r"^\| `src/(\w+)/(\w+)/` \| .* \| (.*) \|$", re.MULTILINE)
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
FORWARD = re.compile(r"^(?:class|struct) (\w+);$", re.MULTILINE)
LAYER_TARGET = re.compile(r"place_recognition_(\w+)")


def names(cell):
    return {name.strip() for name in cell.split(",")} - {"-", ""}


class Rule:
    """The dependencies that the table allows for each folder."""

    def __init__(self, table):
        self.layers = {folder: names(cell) for folder, cell in ROW.findall(table)}
        self.inside = {}
        for layer, folder, cell in SUBFOLDERS.findall(table):
            self.inside.setdefault(layer, {})[folder] = names(cell)

    def mistakes(self, root):
        """Yields rows without a folder, folders without a row, and names that are neither."""
        folders = {path.name for path in (root / "src").iterdir() if path.is_dir()}
        for name in sorted(folders ^ set(self.layers)):
            yield f"src/{name} is either no folder or not in the table of doc/design.md"
        for layer, uses in self.layers.items():
            for name in sorted(uses - set(self.layers) - set(LIBRARIES)):
                yield f"doc/design.md lets src/{layer} use {name}, which is not known"


def library_of(include):
    head = include.split("/")[0]
    return next((name for name, heads in LIBRARIES.items() if head in heads), None)


def complaint(root, rule, path, include):
    """Returns why `path` may not include `include`, or None."""
    parts = path.relative_to(root / "src").parts
    layer, heads = parts[0], include.split("/")
    if (root / "src" / include).exists():
        if heads[0] != layer:
            return None if heads[0] in rule.layers[layer] else f"src/{layer} may not use src/{heads[0]}"
        inside = rule.inside.get(layer, {})
        if len(parts) < 3 or len(heads) < 3 or parts[1] == heads[1] or parts[1] not in inside:
            return None
        allowed = heads[1] in inside[parts[1]]
        return None if allowed else f"src/{layer}/{parts[1]} may not use src/{layer}/{heads[1]}"
    library = library_of(include)
    allowed = library is None or library in rule.layers[layer]
    return None if allowed else f"src/{layer} does not know {library}"


def source_complaints(root, rule):
    for path in sorted((root / "src").rglob("*")):
        if path.suffix in (".h", ".cpp"):
            for include in INCLUDE.findall(path.read_text()):
                reason = complaint(root, rule, path, include)
                if reason:
                    yield f"{path.relative_to(root)} includes {include}: {reason}"
    for path in sorted((root / "include").rglob("*.h")):
        for include in INCLUDE.findall(path.read_text()):
            if library_of(include) == "ROS" or include.split("/")[0] in rule.layers:
                yield f"{path.relative_to(root)} includes {include}: not for a public header"


def shown(header):
    """Yields the lines that users of a header may use, without private members."""
    private = False
    for line in header.splitlines():
        word = line.strip()
        if word in ("public:", "protected:", "private:"):
            private = word == "private:"
        elif line.startswith("}"):
            private = False
        elif not private and not word.startswith(("//", "friend ")) and not FORWARD.match(line):
            yield line


def header_complaints(root):
    for path in sorted((root / "include").rglob("*.h")):
        header = path.read_text()
        for name in FORWARD.findall(header):
            if any(re.search(rf"\b{name}\b", line) for line in shown(header)):
                yield f"{path.relative_to(root)} shows its users {name}, which they cannot use"


def target_complaints(root, rule):
    for layer, uses in rule.layers.items():
        for target in LAYER_TARGET.findall((root / "src" / layer / "CMakeLists.txt").read_text()):
            if target in rule.layers and target != layer and target not in uses:
                yield f"src/{layer}/CMakeLists.txt names place_recognition_{target}: not in the table"


def complaints(root):
    rule = Rule((root / "doc/design.md").read_text())
    yield from rule.mistakes(root)
    yield from source_complaints(root, rule)
    yield from header_complaints(root)
    yield from target_complaints(root, rule)


if __name__ == "__main__":
    found = list(complaints(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "every include follows the layers")
    sys.exit(bool(found))
