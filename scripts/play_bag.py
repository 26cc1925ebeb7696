#!/usr/bin/env python3
"""rosbag play for replay.launch, of the bag that the environment variable BAG names: an absolute path, one
that starts with ~/, or one from the folder where roslaunch was called. Blanks and quotes may be in it."""
import os
import sys

import roslib.packages


def main():
    folder_of_call = os.readlink(f"/proc/{os.getppid()}/cwd")
    bag = os.path.join(folder_of_call, os.path.expanduser(os.environ["BAG"]))
    if not os.path.isfile(bag):
        sys.exit(f"There is no file {bag}; give the bag's path as bag:=PATH.")
    print(f"Playing {bag}.", flush=True)
    player = roslib.packages.find_node("rosbag", "play")[0]
    os.execv(player, [player, *sys.argv[1:], "--bags", bag])


if __name__ == "__main__":
    main()
