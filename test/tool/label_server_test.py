#!/usr/bin/env python3
"""Tests which requests the server of place_tool label answers, and which it refuses."""
import http.client
import json
import pathlib
import tempfile
import unittest

from label_case import TOPIC, LabelCase, Page


class AddressTest(LabelCase):
    """Tests that only the page itself is answered. All tests share a server, because none changes
    anything."""
    served = None

    def setUp(self):
        super().setUp()
        if AddressTest.served is None:
            folder = tempfile.TemporaryDirectory(prefix="place_tool_test_")
            self.addClassCleanup(folder.cleanup)
            AddressTest.shared = pathlib.Path(folder.name)
            self.record(AddressTest.shared / "run.bag")
            AddressTest.served = Page(AddressTest.shared, self.environment(), "run.bag")
            self.addClassCleanup(AddressTest.served.stop)

    def status(self, *arguments, **headers):
        return self.served.request(*arguments, **headers)[0]

    def test_it_listens_on_loopback_only(self):
        port = f"{self.served.port:04X}"
        with open("/proc/net/tcp") as table:
            listening = [line.split()[1] for line in table if line.split()[3] == "0A"]
        self.assertEqual([address for address in listening if address.endswith(":" + port)],
                         ["0100007F:" + port])

    def test_nothing_without_the_token(self):
        for path in ("/", "/recording", "/x/recording", "/index.html", self.served.path[:-2] + "/"):
            self.assertEqual(self.status("GET", path), 403, path)
        self.assertEqual(self.status("GET", ""), 200)

    def test_no_other_name_for_this_computer(self):
        for host in ("evil.example", f"evil.example:{self.served.port}", "127.0.0.1.evil.example"):
            self.assertEqual(self.status("GET", "recording", Host=host), 421, host)
        self.assertEqual(self.status("GET", "recording", Host="localhost:1234"), 200)

    def test_no_other_origin(self):
        for origin in ("http://evil.example", "null", "https://127.0.0.1:%d" % self.served.port,
                       "http://127.0.0.1:1"):
            self.assertEqual(self.status("GET", "recording", Origin=origin), 403, origin)
            self.assertEqual(self.status("POST", "goodbye", "{}", Origin=origin), 403, origin)
        self.assertEqual(self.status("POST", "goodbye", "{}", Origin=""), 403)
        self.assertEqual(self.status("POST", "goodbye", "{}"), 200)
        for site in ("cross-site", "same-site"):
            self.assertEqual(self.status("GET", "recording", Sec_Fetch_Site=site), 403, site)

    def test_one_connection_carries_several_requests(self):
        connection = http.client.HTTPConnection("127.0.0.1", self.served.port, timeout=60)
        for _ in range(2):
            connection.request("POST", self.served.path + "goodbye", '{"more": "than is read"}',
                               {"Origin": f"http://127.0.0.1:{self.served.port}"})
            self.assertEqual(connection.getresponse().read(), b"{}")
            connection.request("GET", self.served.path + "times?topic=" + TOPIC)
            self.assertEqual(len(json.loads(connection.getresponse().read())), 40)
        connection.close()

    def test_no_file_but_those_of_the_page(self):
        for name in ("../server.py", "..%2fserver.py", "server.py", "/etc/passwd", "nothing"):
            path = self.served.path + name
            self.assertIn(self.status("GET", path), (403, 404), name)
        self.assertEqual(self.status("GET", "main.js"), 200)

    def test_malformed_requests_are_refused_and_change_nothing(self):
        for name, body in (("save", "{"), ("save", "[]"), ("save", '{"spans": [{}]}'),
                           ("save", '{"spans": [{"from": 0, "to": "a", "place": "b"}]}'),
                           ("save", '{"spans": [{"from": 0, "to": 1%s, "place": "b"}]}' % ("0" * 400)),
                           ("save", "[" * 100000), ("draft", '{"spans": 5}'), ("draft", '{"spans": {}}'),
                           ("draft", '{"spans": [5]}'), ("draft", '{"spans": [{"from": 0, "to": 1}]}'),
                           ("draft", '{"spans": [{"from": 0, "to": NaN, "place": "b"}]}'),
                           ("draft", '{"spans": [{"from": 0, "to": 1, "place": 5}]}')):
            self.assertEqual(self.status("POST", name, body), 400, body[:80])
        for query in ("times?topic=/no", "picture?topic=/no&frame=0&size=thumb",
                      f"picture?topic={TOPIC}&frame=0", "answers?question=a&after=0", "times"):
            self.assertEqual(self.status("GET", query), 400, query)
        self.assertEqual(self.status("GET", f"picture?topic={TOPIC}&frame=40&size=thumb"), 404)
        self.assertEqual([path.name for path in self.shared.iterdir()], ["run.bag"])


if __name__ == "__main__":
    unittest.main()
