"""Checks that the arrows between the folders of src/ point one way (doc/design.md).

A source may include the public headers, its own folder, and the folders its layer may use; only
src/ros knows ROS.
"""
import pathlib
import re
import sys

MAY_INCLUDE = {
    "base": set(),
    "features": {"base"},
    "learning": {"base"},
    "recognition": {"base", "features", "learning"},
    "tuning": {"base", "learning", "recognition"},
    "evaluation": {"base", "learning", "recognition"},
    "experiments": {"base", "features", "learning", "recognition", "evaluation"},
    "simulation": {"base"},
    "ros": {"base", "recognition"},
    "tool": {"base", "features", "learning", "recognition", "tuning", "evaluation", "experiments",
             "simulation", "ros"},
}
MAY_KNOW = {
    "opencv2": {"features", "recognition", "tuning", "evaluation", "experiments", "simulation", "ros",
                "tool"},
    "svm.h": {"learning"},
    "libsvm": {"learning"},
    "google": {"recognition"},
}
ROS = {"ros", "sensor_msgs", "std_msgs", "std_srvs", "cv_bridge", "rosbag", "image_transport",
       "actionlib", "nodelet", "diagnostic_updater", "dynamic_reconfigure", "pluginlib", "tf2_ros",
       "nav_msgs", "visualization_msgs", "geometry_msgs"}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def complaints(root):
    for path in sorted((root / "src").rglob("*")):
        if path.suffix not in (".h", ".cpp"):
            continue
        layer = path.relative_to(root / "src").parts[0]
        for include in INCLUDE.findall(path.read_text()):
            head = include.split("/")[0]
            where = f"{path.relative_to(root)} includes {include}: "
            if head in MAY_INCLUDE and head != layer and head not in MAY_INCLUDE[layer]:
                # The generated and system headers of ROS share the name of src/ros.
                if not (head == "ros" and layer == "ros"):
                    yield where + f"src/{layer} may not use src/{head}"
            elif head in ROS and layer != "ros" and not (root / "src" / include).exists():
                yield where + "only src/ros knows ROS"
            elif head in MAY_KNOW and layer not in MAY_KNOW[head]:
                yield where + f"src/{layer} does not know {head}"
    for path in sorted((root / "include").rglob("*.h")):
        for include in INCLUDE.findall(path.read_text()):
            if include.split("/")[0] in ROS or include.split("/")[0] in MAY_INCLUDE:
                yield f"{path.relative_to(root)} includes {include}: not for a public header"


if __name__ == "__main__":
    found = list(complaints(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "every include follows the layers")
    sys.exit(bool(found))
