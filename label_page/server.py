"""The page's server. It listens on loopback only and accepts requests only from the page, whose
address contains a token."""
import hmac
import json
import os
import secrets
import threading
import time
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from urllib.parse import parse_qs, urlsplit

from labels_file import Changed, checked, require_spans
from recording import HEIGHTS, Problem

PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "page")
TYPES = {".html": "text/html; charset=utf-8", ".css": "text/css; charset=utf-8",
         ".js": "text/javascript; charset=utf-8", ".svg": "image/svg+xml"}
OWN_NAMES = {"127.0.0.1", "localhost", "[::1]"}
MAX_BODY = 16 << 20

HEADERS = {
    "Content-Security-Policy": "default-src 'self'; frame-ancestors 'none'; base-uri 'none'",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",  # the address holds the token
    "X-Content-Type-Options": "nosniff",
}


class Refusal(Exception):
    """A request that is answered by a status only."""

    def __init__(self, status):
        super().__init__(status)
        self.status = status


class Presence:
    """Tracks whether the page is open. An open page holds a stream of events."""

    # A page that is reloaded reconnects within this time, s.
    PATIENCE = 3

    def __init__(self):
        self.changed = threading.Condition()
        self.version = 0  # of the status that the events report
        self.pages = 0
        self.left = None  # monotonic time at which a page last disconnected, s
        self.said_goodbye = False

    def change(self):
        with self.changed:
            self.version += 1
            self.changed.notify_all()

    def wait_for_change(self, seen, timeout):
        with self.changed:
            self.changed.wait_for(lambda: self.version != seen, timeout)
            return self.version

    def enter(self):
        with self.changed:
            self.pages += 1
            self.said_goodbye = False

    def leave(self):
        with self.changed:
            self.pages -= 1
            self.left = time.monotonic()

    def say_goodbye(self):
        self.said_goodbye = True

    def is_over(self, unsaved):
        """Returns whether the page has gone for good. A page that disappears without a goodbye, as
        when the browser crashes, may still come back for unsaved changes."""
        with self.changed:
            gone = not self.pages and self.left and time.monotonic() - self.left > self.PATIENCE
            return bool(gone and (self.said_goodbye or not unsaved))


class LabelServer(ThreadingHTTPServer):
    """Serves one recording with its labels and a model's opinion. `port` 0: any free port."""
    daemon_threads = True
    allow_reuse_address = True

    def __init__(self, port, recording, topic, labels, opinion, presence):
        super().__init__(("127.0.0.1", port), Handler)
        self.recording = recording
        self.topic = topic
        self.labels = labels
        self.opinion = opinion
        self.presence = presence
        self.token = secrets.token_urlsafe(24)
        self.lock = threading.Lock()
        self.spans = labels.spans()
        self.unsaved = False
        self.writes = 0  # number of drafts and saves
        self.seen = {}  # by page: the number of writes that it knows of
        self.files = {}
        for name in os.listdir(PAGE):
            with open(os.path.join(PAGE, name), "rb") as file:
                self.files[name] = file.read()

    def address(self):
        return f"http://127.0.0.1:{self.server_address[1]}/{self.token}/"

    def handle_error(self, request, client_address):
        pass  # the browser disconnected during an answer

    def describe(self):
        """Returns the recording's description, which the page requests first."""
        with self.lock:
            spans, unsaved = self.spans, self.unsaved
            page = len(self.seen)
            self.seen[page] = self.writes
        return {"page": page,
                "bags": [{"name": os.path.basename(bag.path), "offset": bag.offset}
                         for bag in self.recording.bags],
                "files": [bag.path for bag in self.labels.bags],
                "duration": self.recording.duration,
                "hidden": sum(bag.hidden for bag in self.recording.bags),
                "topics": [{"name": name, "frames": len(times)}
                           for name, times in self.recording.times.items()],
                "topic": self.topic, "spans": spans, "unsaved": unsaved,
                "opinion": self.opinion.status()}


    def require_newest(self, page, overwrite=False):
        """Raises Changed if another page has changed the labels since this one knew them."""
        if self.seen.get(page, self.writes) != self.writes and not overwrite:
            raise Changed("The labels were changed on another page; reload this page to see them.")

    def keep(self, page, spans, unsaved):
        self.spans, self.unsaved = spans, unsaved
        self.writes += 1
        self.seen[page] = self.writes


class Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    server_version = "place_tool"
    sys_version = ""
    timeout = 60

    def do_GET(self):
        self.answer({"recording": self.recording, "times": self.times, "picture": self.image,
                     "answers": self.answers, "events": self.events}, self.file)

    def do_POST(self):
        self.answer({"draft": self.draft, "save": self.save, "learn": self.learn,
                     "goodbye": self.goodbye}, None)

    def answer(self, routes, otherwise):
        try:
            name, query = self.accept()
            work = routes.get(name)
            if work:
                # Read the whole body, because the next request follows on the same connection.
                work(self.body() if self.command == "POST" else query)
            elif otherwise:
                otherwise(name)
            else:
                raise Refusal(HTTPStatus.NOT_FOUND)
        except Refusal as refusal:
            self.close_connection = True
            self.send(b"", "text/plain", status=refusal.status)
        except Changed as problem:
            self.send_json({"problem": str(problem)}, HTTPStatus.CONFLICT)
        except Problem as problem:
            self.send_json({"problem": str(problem)}, HTTPStatus.UNPROCESSABLE_ENTITY)
        except (KeyError, ValueError, TypeError, IndexError, OverflowError, RecursionError):
            self.close_connection = True
            self.send(b"", "text/plain", status=HTTPStatus.BAD_REQUEST)

    def accept(self):
        """Returns the name and the query of a request. Raises Refusal unless the request comes from
        the page."""
        host = self.headers.get("Host", "")
        if host.rpartition(":")[0] not in OWN_NAMES and host not in OWN_NAMES:
            raise Refusal(HTTPStatus.MISDIRECTED_REQUEST)  # another name for this address
        origin = self.headers.get("Origin")
        if origin is None and self.command == "POST" or origin not in (None, f"http://{host}"):
            raise Refusal(HTTPStatus.FORBIDDEN)
        opens_page = self.headers.get("Sec-Fetch-Dest") == "document"
        if self.headers.get("Sec-Fetch-Site", "none") not in ("same-origin", "none") \
                and not opens_page:
            raise Refusal(HTTPStatus.FORBIDDEN)
        address = urlsplit(self.path)
        token, slash, name = address.path[1:].partition("/")
        if not slash or not hmac.compare_digest(token.encode(), self.server.token.encode()):
            raise Refusal(HTTPStatus.FORBIDDEN)
        return name, {key: values[0] for key, values in parse_qs(address.query).items()}

    def body(self):
        size = int(self.headers.get("Content-Length", ""))
        if not 0 <= size <= MAX_BODY:
            raise Refusal(HTTPStatus.REQUEST_ENTITY_TOO_LARGE)
        return json.loads(self.rfile.read(size))

    # GET

    def file(self, name):
        name = name or "index.html"
        if name not in self.server.files:
            raise Refusal(HTTPStatus.NOT_FOUND)
        self.send(self.server.files[name], TYPES[os.path.splitext(name)[1]])

    def recording(self, _):
        self.send_json(self.server.describe())

    def times(self, query):
        self.send_json([round(time, 6) for time in self.server.recording.times[query["topic"]]])

    def image(self, query):
        topic, number, size = query["topic"], int(query["frame"]), query["size"]
        if size not in HEIGHTS or not 0 <= number < len(self.server.recording.times[topic]):
            raise Refusal(HTTPStatus.NOT_FOUND)
        image = self.server.recording.image(topic, number, size)
        self.send(image, "image/jpeg", cache="private, max-age=86400, immutable")

    def answers(self, query):
        self.send_json(self.server.opinion.since(int(query["question"]), int(query["after"])))

    def events(self, _):
        """Reports the model's status to the page until the page disconnects."""
        self.close_connection = True
        self.start(HTTPStatus.OK, {"Content-Type": "text/event-stream",
                                   "Cache-Control": "no-store"})
        presence = self.server.presence
        presence.enter()
        version = None
        try:
            while True:
                before, version = version, presence.wait_for_change(version, 0.5)
                event = ": still here"
                if version != before:
                    event = "data: " + json.dumps(self.server.opinion.status())
                self.wfile.write(event.encode() + b"\n\n")
                time.sleep(0.2)  # batches the answers, which arrive by the hundred
        except OSError:
            pass
        finally:
            presence.leave()

    # POST

    def draft(self, body):
        spans, page = body["spans"], body.get("page")
        require_spans(spans)
        with self.server.lock:
            self.server.require_newest(page)
            self.server.keep(page, spans, not body.get("saved", False))
        self.send_json({})

    def save(self, body):
        spans, page, overwrite = body["spans"], body.get("page"), body.get("overwrite") is True
        with self.server.lock:
            self.server.require_newest(page, overwrite)
            files = self.server.labels.save(spans, overwrite)
            self.server.keep(page, spans, False)
        self.send_json({"files": files})

    def learn(self, body):
        spans = checked(body["spans"])
        topic = self.server.recording.topic(body.get("topic") or self.server.topic)
        self.server.opinion.learn([bag.labels(spans) for bag in self.server.labels.bags], topic)
        self.send_json({})

    def goodbye(self, _):
        self.server.presence.say_goodbye()
        self.send_json({})

    # Responses

    def start(self, status, headers):
        self.send_response(status)
        for name, value in {**HEADERS, **headers}.items():
            self.send_header(name, value)
        if self.close_connection:
            self.send_header("Connection", "close")
        self.end_headers()

    def send(self, data, type_, status=HTTPStatus.OK, cache="no-store"):
        self.start(status, {"Content-Type": type_, "Content-Length": str(len(data)),
                            "Cache-Control": cache})
        self.wfile.write(data)

    def send_json(self, value, status=HTTPStatus.OK):
        data = json.dumps(value, ensure_ascii=False).encode(errors="replace")  # names of files
        self.send(data, "application/json; charset=utf-8", status)

    def log_message(self, *_):
        pass
