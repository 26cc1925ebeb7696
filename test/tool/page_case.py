"""Shared code of the tests of place_tool label in a real browser."""
import sys
import tempfile
from bisect import bisect_left

from label_case import LabelCase

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import WebDriverWait
    BROWSER, DRIVER = "/usr/bin/chromium", "/usr/bin/chromedriver"
    open(BROWSER).close()
    open(DRIVER).close()
except (ImportError, OSError):
    print("Skipped: this test needs chromium, chromium-driver and python3-selenium.")
    sys.exit(77)

OPTIONS = ("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
           "--disable-background-networking", "--disable-component-update", "--disable-sync",
           "--window-size=1400,900")
# Positions of the strip's rows in the canvas, pixels from its top.
RULER, THUMBS, LABELS = 8, 70, 145


def start_browser(folder):
    options = webdriver.ChromeOptions()
    options.binary_location = BROWSER
    for option in (*OPTIONS, f"--user-data-dir={folder}"):
        options.add_argument(option)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service(DRIVER), options=options)


class PageCase(LabelCase):
    @classmethod
    def setUpClass(cls):
        profile = tempfile.TemporaryDirectory(prefix="place_tool_browser_")
        cls.addClassCleanup(profile.cleanup)
        cls.browser = start_browser(profile.name)
        cls.addClassCleanup(cls.browser.quit)

    def tearDown(self):
        errors = [entry["message"] for entry in self.browser.get_log("browser")
                  if entry["level"] == "SEVERE" and "'beforeunload'" not in entry["message"]]
        self.browser.get("about:blank")
        self.assertEqual(errors, [])

    def open(self, *arguments):
        self.served = self.page(*arguments)
        self.load()
        return self.served

    def load(self):
        self.browser.get(self.served.address)
        self.wait(lambda: self.script("return document.title") and self.rooms_shown())
        self.wait(self.strip_is_complete)

    def wait(self, condition, seconds=60):
        WebDriverWait(self.browser, seconds, poll_frequency=.05).until(lambda _: condition())

    def script(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def element(self, name):
        return self.browser.find_element(By.ID, name)

    def text(self, name):
        return self.script("return document.getElementById(arguments[0]).textContent", name)

    def rooms_shown(self):
        """Returns the list of rooms: name -> key."""
        return dict(self.script(
            "return [...document.querySelectorAll('.room')].map(button =>"
            "[button.querySelector('.room-name').textContent,"
            " button.querySelector('kbd')?.textContent ?? ''])"))

    def strip_is_complete(self):
        """Returns whether all thumbnails in view are loaded: no pixel shows an empty slot."""
        return self.script("""
            const canvas = document.getElementById("timeline");
            const scale = canvas.width / canvas.clientWidth;
            const row = canvas.getContext("2d").getImageData(0, 70 * scale, canvas.width, 1).data;
            for (let i = 0; i < row.length; i += 4) {
              if (row[i] === 0x26 && row[i + 1] === 0x2a && row[i + 2] === 0x30) return false;
            }
            return row.some(value => value);""")

    def press(self, *keys):
        for key in keys:
            ActionChains(self.browser).send_keys(key).perform()

    def control(self, key):
        ActionChains(self.browser).key_down(Keys.CONTROL).send_keys(key).key_up(
            Keys.CONTROL).perform()

    def x(self, time_):
        """Returns the x coordinate of a time when the whole recording is in view, pixels."""
        width = self.element("timeline").size["width"]
        duration = self.served.get("recording")["duration"]
        return 12 + time_ / duration * (width - 24)

    def at(self, time_, row):
        """Returns an action that moves the mouse to a time in a row of the strip."""
        strip = self.element("timeline")
        return ActionChains(self.browser, duration=20).move_to_element_with_offset(
            strip, round(self.x(time_) - strip.size["width"] / 2), row - strip.size["height"] // 2)

    def click(self, time_, row=THUMBS):
        self.at(time_, row).click().perform()

    def drag(self, begin, end, row=THUMBS):
        steps = round(self.x(end) - self.x(begin))
        self.at(begin, row).click_and_hold().move_by_offset(steps // 2, 0).move_by_offset(
            steps - steps // 2, 0).release().perform()

    def add_room(self, name):
        """Types the name; characters that the driver cannot type are pasted."""
        field = self.element("room-name")
        if all(ord(character) < 0x10000 for character in name):
            field.send_keys(name)
        else:
            self.script("arguments[0].value = arguments[1]", field, name)
        field.send_keys(Keys.ENTER)

    def save(self):
        self.control("s")
        self.wait(lambda: self.text("message").startswith("Saved"))

    def drafted(self):
        """Returns the page's labels as (place, first frame, frame after the last)."""
        recording = self.served.get("recording")
        times = self.served.get("times?topic=" + recording["topic"])
        return [(label["place"], bisect_left(times, label["from"]), bisect_left(times, label["to"]))
                for label in recording["spans"]]

    def wait_for(self, *spans):
        try:
            self.wait(lambda: self.drafted() == list(spans), 10)
        except Exception:
            self.assertEqual(self.drafted(), list(spans))
