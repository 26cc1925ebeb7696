"""place_tool label: serves a page for labelling a recording in the browser.

place_tool checks the arguments and runs this folder with Python; see src/tool/label.cpp.
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
    parser.add_argument("--tool", required=True, help="path of place_tool")
    parser.add_argument("--model", default="")
    parser.add_argument("--port", type=int, default=0)
    parser.add_argument("--no-browser", action="store_true")
    parser.add_argument("--image-topic", default="")
    for option in ("--label-topic", "--labels", "--label"):
        parser.add_argument(option, default="")
    parser.add_argument("--initial-label", action="append", default=[],
                        help="for each bag in turn")
    return parser.parse_args(arguments)


def reading_options(options):
    """Returns the options that tell place_tool where the labels come from."""
    pairs = (("--label-topic", options.label_topic), ("--labels", options.labels),
             ("--label", options.label))
    return [f"{option}={value}" for option, value in pairs if value]


def make_server(options):
    from labels_file import RecordingLabels
    from opinion import Opinion
    from recording import Recording
    from server import LabelServer, Presence
    recording = Recording(options.bags)
    topic = recording.topic(options.image_topic)
    initial = dict(zip(options.bags, options.initial_label))
    labels = RecordingLabels(options.tool, recording, reading_options(options), initial)
    presence = Presence()
    opinion = Opinion(options.tool, recording, topic, presence.change)
    server = LabelServer(options.port, recording, topic, labels, opinion, presence)
    if options.model:
        opinion.ask(options.model)
    return server


def show(server, options):
    """Prints the page's address, and opens the page if there is a display."""
    sys.stdout.reconfigure(errors="surrogateescape")  # names of bags are any bytes
    print(f"Labels of {', '.join(os.path.basename(bag) for bag in options.bags)}: "
          f"{server.address()}", flush=True)
    if options.no_browser:
        return
    if os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"):
        threading.Thread(target=webbrowser.open, args=(server.address(),), daemon=True).start()
        return
    port = server.server_address[1]
    print("This computer has no display. On another computer, run ssh -L "
          f"{port}:127.0.0.1:{port} THIS_COMPUTER and open the address there.", flush=True)


def serve(server):
    """Serves the page until it is closed or the process receives a signal, such as Ctrl-C."""
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
        return (f"{error} for {sys.executable}; install the packages that package.xml of "
                "place_recognition lists.")
    except OSError as error:
        return f"{error.filename or 'port ' + str(options.port)}: {error.strerror}."
    except Exception as error:  # Problem, or any of rosbag's exceptions
        return " ".join(str(error).split())
    show(server, options)
    serve(server)
    return None


if __name__ == "__main__":
    message = main()
    if message:
        sys.exit(f"place_tool label: {message}")
