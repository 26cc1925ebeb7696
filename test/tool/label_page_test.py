#!/usr/bin/env python3
"""Tests place_tool label in a real browser: mouse and keyboard actions, and the labels saved."""
import json
import time
import unittest

from page_case import LABELS, Keys, PageCase


class LabellingTest(PageCase):
    def setUp(self):
        super().setUp()
        self.record("run.bag", frames=100, rate=10)  # borders between frames at .05, .15, ...

    def test_drag_keys_save_and_reload(self):
        self.open("run.bag")
        self.assertEqual(self.rooms_shown(), {"no room": "0"})
        for room in ("kitchen", "corridor"):
            self.add_room(room)
        self.assertEqual(self.rooms_shown(), {"kitchen": "1", "corridor": "2", "no room": "0"})
        self.drag(1.95, 3.95)
        self.press("1")
        self.wait_for(("kitchen", 20, 40))
        self.click(6.05)
        self.press("2")  # from here to the end
        self.wait_for(("kitchen", 20, 40), ("corridor", 60, 100))
        self.save()
        self.assertEqual(self.files(), ["run.bag", "run.labels.yaml"])
        saved = self.stretches("run.bag")
        self.assertEqual([stretch[0] for stretch in saved], ["kitchen", "corridor"])
        self.load()
        self.assertEqual(self.drafted(), [("kitchen", 20, 40), ("corridor", 60, 100)])
        self.assertEqual(set(self.rooms_shown()), {"kitchen", "corridor", "no room"})
        self.assertFalse(self.element("save").is_enabled())

    def test_from_here_ends_at_the_next_border(self):
        self.labelled(("kitchen", 0, 10))
        self.click(5.05)
        self.add_room("corridor")
        self.press("2")
        self.wait_for(("kitchen", 0, 50), ("corridor", 50, 100))
        self.click(2.05)
        self.press("0")
        self.wait_for(("kitchen", 0, 20), ("corridor", 50, 100))
        self.press("1")
        self.wait_for(("kitchen", 0, 50), ("corridor", 50, 100))

    def labelled(self, *spans):
        lines = "".join(f"  - {{from: {begin}, to: {end}, place: {place}}}\n"
                        for place, begin, end in spans)
        (self.folder / "run.labels.yaml").write_text("labels:\n" + lines)
        self.open("run.bag")

    def test_borders_are_moved_split_and_undone(self):
        self.labelled(("kitchen", 0, 5), ("corridor", 5, 10))
        before = [("kitchen", 0, 50), ("corridor", 50, 100)]
        self.wait_for(*before)
        self.drag(5.0, 2.95, LABELS)
        moved = [("kitchen", 0, 30), ("corridor", 30, 100)]
        self.wait_for(*moved)
        self.drag(2.95, .01, LABELS)  # not past the previous border
        self.assertEqual([label[0] for label in self.drafted()], ["kitchen", "corridor"])
        self.control("z")
        self.wait_for(*moved)
        self.click(7.05)
        self.press("/")
        split = [("kitchen", 0, 30), ("corridor", 30, 70), ("corridor", 70, 100)]
        self.wait_for(*split)
        self.click(8.05, LABELS)  # selects the span
        self.press("1")
        self.wait_for(("kitchen", 0, 30), ("corridor", 30, 70), ("kitchen", 70, 100))
        self.control("z")
        self.wait_for(*split)
        self.control("z")
        self.control("z")
        self.wait_for(*before)
        self.control("y")
        self.wait_for(*moved)
        self.click(8.05, LABELS)
        self.press(Keys.DELETE)
        self.wait_for(("kitchen", 0, 30))

    def test_a_room_is_renamed(self):
        self.labelled(("kitchen", 0, 5), ("corridor", 5, 10))
        self.script("document.querySelector('.rename').click()")
        alert = self.browser.switch_to.alert
        alert.send_keys("galley")
        alert.accept()
        self.wait_for(("galley", 0, 50), ("corridor", 50, 100))
        self.assertEqual(self.rooms_shown(), {"galley": "1", "corridor": "2", "no room": "0"})

    def test_steps_and_the_image(self):
        self.labelled(("kitchen", 0, 5))
        self.press(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT)
        self.assertIn("frame 3 of 100", self.text("caption"))
        self.press(Keys.END)
        self.assertIn("frame 100 of 100", self.text("caption"))
        self.control(Keys.ARROW_LEFT)
        self.assertIn("frame 51 of 100", self.text("caption"))
        self.wait(lambda: "frame=50&" in self.script("return document.getElementById('image').src"))
        self.press("?")
        self.assertTrue(self.element("keys").is_displayed())
        self.press(Keys.ESCAPE)

    def test_names_of_every_kind(self):
        names = ["Elin's office", 'a "b" \\ {c: d}, [e] # f', "- x: 'y'", "<b>&amp;</b>", "Küche",
                 "廊下 №5", "غرفة", "👩‍🍳 kitchen", "null", "0x1F", "~", "*a &b !c %d @e `f", "a" * 128]
        self.open("run.bag")
        for name in names:
            self.add_room("  " + name)
        for again in ("Ku\u0308che", "K\u200b\u00fcche ", "Elin's\u00a0 office"):
            self.add_room(again)
        self.assertEqual(list(self.rooms_shown())[:-1], names)
        for refused in ("unknown", "x" * 129, "ü" * 65, " "):
            self.add_room(refused)
            self.assertNotIn(refused, self.rooms_shown())
            self.script("document.getElementById('room-name').value = ''")
        self.element("timeline").click()
        for i, name in enumerate(names):
            self.click(i * .7 + .05)
            self.press("123456789abcdefg"[i])
        self.wait(lambda: len(self.drafted()) == len(names))
        self.save()
        self.assertEqual([stretch[0] for stretch in self.stretches("run.bag")], names)
        self.load()
        self.assertEqual([label[0] for label in self.drafted()], names)

    def test_unsaved_changes_survive_a_reload_and_closing_the_page_ends_the_program(self):
        self.labelled(("kitchen", 0, 5))
        self.click(2.05)
        self.press("0")
        self.wait_for(("kitchen", 0, 20))
        self.browser.get("about:blank")
        time.sleep(.5)
        self.load()
        self.wait_for(("kitchen", 0, 20))
        self.assertTrue(self.element("save").is_enabled())
        self.save()
        self.browser.get("about:blank")
        self.served.process.wait(timeout=30)
        self.assertEqual(self.served.stop(), (0, "The page was closed.\n"))

    def test_a_foreign_page_can_neither_read_nor_change_anything(self):
        self.labelled(("kitchen", 0, 5))
        address = self.served.address
        (self.folder / "evil.html").write_text("<title>evil</title>")
        for elsewhere in ("about:blank", (self.folder / "evil.html").as_uri()):
            self.browser.get(elsewhere)
            told = self.browser.execute_async_script("""
                const [address, done] = arguments;
                const attempts = [
                  fetch(address + "recording").then(answer => answer.text()),
                  fetch(address + "save", {method: "POST", body: '{"spans": []}'}),
                  new Promise((good, bad) => {
                    const image = new Image();
                    image.onload = good;
                    image.onerror = bad;
                    image.src = address + "picture?frame=0&size=thumb&topic=%2Fcamera%2Fimage_raw%2Fcompressed";
                  }),
                  fetch(address + "save", {method: "POST", mode: "no-cors", body: '{"spans": []}'})
                      .then(() => { throw 0; })];
                Promise.allSettled(attempts).then(all => done(all.map(one => one.status)));""",
                                                     address)
            self.assertEqual(told, ["rejected"] * 4, elsewhere)
            self.browser.get_log("browser")  # the refusals
        self.assertEqual(self.served.get("recording")["spans"][0]["place"], "kitchen")
        self.assertEqual(self.files(), ["evil.html", "run.bag", "run.labels.yaml"])


class SizeTest(PageCase):
    FRAMES = 10_000

    def test_ten_thousand_frames(self):
        self.record("run.bag", frames=self.FRAMES, rate=25)
        self.open("run.bag")
        self.assertIn(f"{self.FRAMES} frames", self.text("topic"))
        self.add_room("kitchen")
        self.drag(100, 300)
        self.press("1")
        frames = self.script("""
            window.frames_drawn = [];
            let last = performance.now();
            const look = now => {
              frames_drawn.push(now - last);
              last = now;
              requestAnimationFrame(look);
            };
            requestAnimationFrame(look);""")
        strip = self.element("timeline")
        for _ in range(12):  # zooms in until there is a thumbnail for each frame
            self.script("""arguments[0].dispatchEvent(new WheelEvent("wheel",
                {deltaY: -300, clientX: 700, clientY: arguments[0].getBoundingClientRect().top + 50,
                 cancelable: true}))""", strip)
        self.wait(self.strip_is_complete)
        for _ in range(100):
            self.script("""arguments[0].dispatchEvent(new WheelEvent("wheel",
                {deltaX: 200, cancelable: true}))""", strip)
        self.wait(self.strip_is_complete)
        frames = sorted(self.script("return frames_drawn"))
        print(f"{len(frames)} redraws, median {frames[len(frames) // 2]:.0f} ms, 99 % within "
              f"{frames[len(frames) * 99 // 100]:.0f} ms")
        self.press(Keys.END)
        self.assertIn(f"frame {self.FRAMES} of", self.text("caption"))
        self.save()
        (place, begin, end), = self.stretches("run.bag")
        self.assertEqual(place, "kitchen")
        self.assertAlmostEqual(begin, 100, delta=1)
        self.assertAlmostEqual(end, 300, delta=1)
        # Thumbnails are made as they come into view, not all at once.
        loaded = self.script("return performance.getEntriesByType('resource')"
                             ".filter(entry => entry.name.includes('size=thumb')).length")
        self.assertLess(loaded, 1000)


class TopicsTest(PageCase):
    def test_another_topic_shows_the_same_labels(self):
        self.record("run.bag", topics=("/front/compressed", "/rear/compressed"),
                    labels=[(0, "kitchen"), (20, "corridor")])
        self.open("run.bag")
        self.script("""const topic = document.getElementById("topic");
            topic.value = "/rear/compressed";
            topic.dispatchEvent(new Event("change"));""")
        self.wait(lambda: "rear" in self.script("return document.getElementById('image').src"))
        self.assertEqual(self.rooms_shown(), {"kitchen": "1", "corridor": "2", "no room": "0"})

    def test_split_bags_are_one_strip(self):
        self.record("run_0.bag", frames=30)
        self.record("run_1.bag", frames=30, start=1700000003.5)
        self.open("run_0.bag", "run_1.bag")
        self.add_room("kitchen")
        self.drag(1.05, 5.05)
        self.press("1")
        self.save()
        for bag in ("run_0.bag", "run_1.bag"):
            self.assertEqual([stretch[0] for stretch in self.stretches(bag)], ["kitchen"])


if __name__ == "__main__":
    unittest.main()
