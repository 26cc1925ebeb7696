"""place_tool label: a page in the browser on which a recording is labelled.

place_tool starts this folder with Python and checks the arguments; see src/tool/label.cpp.
"""
import argparse
import os
import signal
import sys
import threading
import webbrowser


def parse(arguments):
    parser = argparse.ArgumentParser(prog="place_tool label")
    parser.add_argument("bags", nargs="+")
    parser.add_argument("--tool", required=True, help="the program place_tool")
    parser.add_argument("--model", default="")
    parser.add_argument("--port", type=int, default=0)
    parser.add_argument("--no-browser", action="store_true")
    parser.add_argument("--image-topic", default="")
    for option in ("--label-topic", "--labels", "--label"):
        parser.add_argument(option, default="")
    return parser.parse_args(arguments)


def reading_options(options):
    """Where labels come from, for place_tool."""
    pairs = (("--label-topic", options.label_topic), ("--labels", options.labels),
             ("--label", options.label))
    return [word for option, value in pairs if value for word in (option, value)]


def make_server(options):
    from labels_file import RecordingLabels
    from opinion import Opinion
    from recording import Recording
    from server import LabelServer, Presence
    recording = Recording(options.bags)
    topic = recording.topic(options.image_topic)
    labels = RecordingLabels(options.tool, recording, reading_options(options))
    presence = Presence()
    opinion = Opinion(options.tool, recording, topic, presence.change)
    server = LabelServer(options.port, recording, topic, labels, opinion, presence)
    if options.model:
        opinion.ask(options.model)
    return server


def show(server, options):
    """Opens the page where there is a display; says its address in any case."""
    print(f"Labels of {', '.join(os.path.basename(bag) for bag in options.bags)}: "
          f"{server.address()}", flush=True)
    if options.no_browser:
        return
    if os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"):
        threading.Thread(target=webbrowser.open, args=(server.address(),), daemon=True).start()
        return
    port = server.server_address[1]
    print("There is no display here. From another computer: ssh -L "
          f"{port}:127.0.0.1:{port} THIS_COMPUTER, then open the address there.", flush=True)


def serve(server):
    """Until the page is closed, or Ctrl-C."""
    stopped = threading.Event()
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, lambda *_: stopped.set())
    threading.Thread(target=server.serve_forever, daemon=True).start()
    while not stopped.wait(0.2):
        if server.presence.is_over(server.unsaved):
            print("The page was closed.", flush=True)
            break
    server.opinion.stop()
    server.shutdown()
    if server.unsaved:
        print("Some changes were not saved.", flush=True)


def main():
    options = parse(sys.argv[1:])
    try:
        server = make_server(options)
    except ImportError as error:
        return (f"{error} for {sys.executable}; install what package.xml of place_recognition "
                "names.")
    except OSError as error:
        return f"{error.filename or 'port ' + str(options.port)}: {error.strerror}."
    except Exception as error:  # rosbag's many kinds, and Problem
        return " ".join(str(error).split())
    show(server, options)
    serve(server)
    return None


if __name__ == "__main__":
    message = main()
    if message:
        sys.exit(f"place_tool label: {message}")
