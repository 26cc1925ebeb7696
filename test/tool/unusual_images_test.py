#!/usr/bin/env python3
"""Rare but valid kinds of images: each is recognized as its room, so its colours are right."""
import base64
import json
import struct
import unittest
import zlib

import cv2
import numpy as np
from tool_case import ToolCase, paint

# paint("kitchen", 3), reduced, in kinds that OpenCV does not write (cjpeg, ImageMagick); base64.
JPEGS = {
    "CMYK, as for print":
        "/9j/7gAOQWRvYmUAZAAAAAAC/9sAQwAUDg8SDw0UEhASFxUUGB4yIR4cHB49LC4kMklATEtHQEZFUFpzYlBVbVZF"
        "RmSIZW13e4GCgU5gjZeMfZZzfoF8/9sAQwEVFxceGh47ISE7fFNGU3x8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8"
        "fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8/8AAFAgAMABABAEiAAIRAQMRAQQRAP/EABoAAQADAQEBAAAAAAAAAAAA"
        "AAABAwUCBAb/xAApEAACAQMCBAYDAQAAAAAAAAAAAQIDBBESMRQhQVIFUVRxkqETIiSB/8QAGgEAAgMBAQAAAAAA"
        "AAAAAAAAAAECAwQGBf/EACIRAAICAQMEAwAAAAAAAAAAAAABAgMRBBIhEzFRkRRSof/aAA4EAQACEQMRBAAAPwD5"
        "oEuMkstPHsQdAmn2Mp9KAAMYBdZ041biMZ81vgpJp1JU5qUHhoqtjKVbjF4ZFrK4Iex7fEaNOnplCKi3yaWx4S2v"
        "cVLhpza5bJbFRXpa511KNjyxQTSwwjY0Q4TZY05/0xj0uncuGlp6fLKOOGrdn2jJpFXRu3WJ5fklCmcc5RQry29R"
        "R+aKkm2kllvoX1rSrRgpzSw98dPc6traf54Of6KLzlmjcxVWhOCmlnqF+t2WwjBpp9yM98ZJY/DpXVu02q9NpbtT"
        "RimhV8OjC2clJ64rLfRnkVtV7fs06spTtnBTjrccN6dyOr1D3Q6U1jPPIWQsTWE/RxK9tuX9FL5oxiS3hqvZ9jh6"
        "vZ9m/wCRT917Rb05+DrjLX1NH5o0mEw9wkcieofJBhIZyEAAAjqSwGBnzBAQCB//2Q==",
    "arithmetic coding":
        "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDABQODxIPDRQSEBIXFRQYHjIhHhwcHj0sLiQySUBMS0dARkVQWnNiUFVt"
        "VkVGZIhlbXd7gYKBTmCNl4x9lnN+gXz/2wBDARUXFx4aHjshITt8U0ZTfHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8"
        "fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHz/yQARCAAwAEADASIAAhEBAxEB/8wACgAQEAUBEBEF/9oADAMBAAIR"
        "AxEAPwDSLJKUp48zQemajUWMhmqjumGPujclSw0StKCp6LFVBi/8jG8TQJloc3i6FX5wy2ImZwL9ZDch3PLG4lPq"
        "Qg22bmBx10a/ip6zcEegei2kRCN/P5XOZdFdj3z2TgL8ogB47aQv5El7djZQS/Y0dnUguZqgQL8g3jCs1uF81kfs"
        "g1tDz/lnb0o0pv6X2eplUOVUlvTO/HOE1+h94QVJCjA1f4xavN72ZhuT8nG5aAR7DtKfq+eIthfjyOjadnOREAe0"
        "ejUd2RuTRiV9tfFvzyArteDzIVe0+OAgSY2HZLAT+LKdCodZg5aFI2CCXa0JDaBuaSYGzDSKc9u2Ip9TfMofiSbO"
        "lryEuz/ee6D/2Q==",
    "arithmetic coding, progressive":
        "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDABQODxIPDRQSEBIXFRQYHjIhHhwcHj0sLiQySUBMS0dARkVQWnNiUFVt"
        "VkVGZIhlbXd7gYKBTmCNl4x9lnN+gXz/2wBDARUXFx4aHjshITt8U0ZTfHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8"
        "fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHz/ygARCAAwAEADASIAAhEBAxEB/8wABgAQARD/2gAMAwEAAhADEAAA"
        "AdC3JQN5N+pg9Tq5ibScDGRHM0ZHVOvSQLJEd+2Gd3CD7Lb/zAAEEAX/2gAIAQEAAQUCzmWEiVB61IH24iYgxeOt"
        "NVsAqy+6Ra+fY2MMcWSHK8gG/8wABBEF/9oACAEDAQE/AdaWLYCHq5p6I4D/zAAEEQX/2gAIAQIBAT8B4eUYp9tZ"
        "3Ix9X9uUVMctNkhYgSGiotwg/8wABBAF/9oACAEBAAY/ArTk8DbceWGA/8wABBAF/9oACAEBAAE/IbaO4yoFeEtt"
        "cxiJzu06+7Qk8KhvqTlaLY9vwZlmY/34xnzDYIr/2gAMAwEAAgADAAAAEOaCDx9q1qeEDID/zAAEEQX/2gAIAQMB"
        "AT8Q3+8OTCSXl9sUqE5OQP/MAAQRBf/aAAgBAgEBPxAxSf4kfQwRAYGsJsCj7YgNo4ElCqSb4P/MAAQQBf/aAAgB"
        "AQABPxCycfbLYs7ASoC8R0pYs4T01siQF0iE3khaAavDBjyP6sjMy3UnQdVZarr1abzzlU7NIXqZPTBQN/u8psTr"
        "ydpjW5AJhyneyRqA/9k=",
    "colours at a quarter of the width":
        "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDABQODxIPDRQSEBIXFRQYHjIhHhwcHj0sLiQySUBMS0dARkVQWnNiUFVt"
        "VkVGZIhlbXd7gYKBTmCNl4x9lnN+gXz/2wBDARUXFx4aHjshITt8U0ZTfHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8"
        "fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHz/wAARCAAwAEADAUEAAhEBAxEB/8QAGgABAAIDAQAAAAAAAAAAAAAA"
        "AAMFAQIEBv/EACgQAAIBAwEIAQUAAAAAAAAAAAABAgMEERIFFSExQVOi0VEUM3Ghsf/EABkBAAIDAQAAAAAAAAAA"
        "AAAAAAACAQMEBf/EACMRAAEEAQMEAwAAAAAAAAAAAAABAgMRIQQSsRMxQVEiwfD/2gAMAwEAAhEDEQA/ALkAHDNA"
        "ILupKnQbi8PkQ2FWc3KM5OSXHidpoRidBXeb+hq+NmFKLeE1n8mQChUrCig0qQjUi4yWUzWjQhQT05y+rJRt67Nn"
        "juTeKKjVL6jm85/RbmG0k23hIhpXVOrNxi3npnqatRGr9Q5rf2B3JbqQmOClfzncKLS0SeEuqLAFL40bGx3u+RVT"
        "CKVy2js5S1Kos/OiXo33vZd/wl6NK+1rR0pRhU1Slwxpa/px0rylQqxqOSaXRPibIIZUl3P9LwQyRquyp3va9lj7"
        "3i/RW0ry2hcKb1aE8r5RZb3su94y9De1l3vCXorfBK6Nra7XyKsjaTJ5cyAdQxgAAAAAAAAAH//Z",
    "red, green and blue instead of brightness and colour":
        "/9j/7gAOQWRvYmUAZAAAAAAA/9sAQwAbEhQXFBEbFxYXHhwbIChCKyglJShROj0wQmBVZWRfVV1baniZgWpxkHNb"
        "XYW1hpCeo6utq2eAvMm6pseZqKuk/8AAEQgAMABAA1IRAEcRAEIRAP/EABoAAQACAwEAAAAAAAAAAAAAAAADBQEC"
        "BAb/xAAuEAACAgIAAwgABQUAAAAAAAAAAQIDBBEFEiETFTFBUVOi0SIzYXGBQnKCkcH/2gAMA1IARwBCAAA/ALst"
        "SrAAAAAAMSfQ5uI3TpxZSrepb1v0OvhlEL8yMLFuKTevUxB72c3CMi21zhZNySW031Z1caxqalXZXBQbemo9EbFk"
        "VQ2aqyDelKLfps2dc0tuEkvXQNjUAAAAGGtml1ULq3Ca3Fm9N06LFZXLUkFHRHi4lWKmq0234t+JJl5luXJOxpJe"
        "EY+BknICL+o88p2LMTTafNr+D0zhW8FpqLXLv+SU9CeZAk1GLbaSXVtiKcpKMU230SXmYUk2c2Pn0ZFrrg2pLw2t"
        "c37HVk8OyMapWWJOL8eV75f3MnScpGrG5foVNHFbLMyMXFdnOXKl5ot7+FV14cpKT7SEeZvyZIWxUAA4e9sDf5/w"
        "l9HAsnh0bFNSXMvPlZ0SuyZVutzfK/Iz3vg+/wDCX0S95Ynu/F/RD2cvQd7YUvwq9bfTrFr/AIQ5fEceWNONcnOU"
        "k4601rfmSYydeRXZJdIyUnr9GZedi1rmd9bS9Jbf+kVmJcsfJha02o+KRccTyabMKUIWKUp61ry6p9fQx3vg+/8A"
        "CX0XL4lia/N3/iyj7OXoRLimEpb7bp/a/opqJU15kbHGXZqW0t9UWl3EZ2Yrq5UpyWnLyJe98H3/AIS+i57yxPd+"
        "L+ir7OXoO98H3/hL6HeWJ7vxf0Ozl6HlygJwAAAAAAAAAAAAAAAAAYAMgAAH/9k=",
}


def png(rows, bits, color_type, *extra):
    """Returns a PNG file with these rows of bytes; `extra`: further chunks, (type, data)."""
    def chunk(type_, data):
        return (struct.pack(">I", len(data)) + type_ + data +
                struct.pack(">I", zlib.crc32(type_ + data)))

    header = struct.pack(">IIBBBBB", 128, 96, bits, color_type, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
            b"".join(chunk(*each) for each in extra) +
            chunk(b"IDAT", zlib.compress(b"".join(b"\0" + bytes(row) for row in rows))) +
            chunk(b"IEND", b""))


def pngs(image):
    """Returns the image in kinds of PNG that OpenCV does not write; `image` is BGR."""
    rgb = image[..., ::-1]
    levels = (rgb // 64).astype(np.uint8)  # 64 palette colours
    indices = levels[..., 0] * 16 + levels[..., 1] * 4 + levels[..., 2]
    palette = bytes(channel * 64 + 32 for i in range(64) for channel in (i // 16, i // 4 % 4, i % 4))
    alpha = np.full(rgb.shape[:2] + (1,), 128, np.uint8)
    return {"palette": png(indices, 8, 3, (b"PLTE", palette)),
            "palette with transparency": png(indices, 8, 3, (b"PLTE", palette),
                                             (b"tRNS", bytes([0] * 64))),
            "half transparent": png(np.dstack([rgb, alpha]).reshape(96, -1), 8, 6),
            "a text chunk": png(rgb.reshape(96, -1), 8, 2, (b"tEXt", b"Comment\0" + b"x" * 70000)),
            "a private chunk": png(rgb.reshape(96, -1), 8, 2, (b"roBo", b"1"))}


class UnusualImagesTest(ToolCase):
    def setUp(self):
        super().setUp()
        self.write_run("run", views=8)
        self.succeed("train", "run", "--model", "./home.places", "--config", "crfh_colour")

    def assert_kitchen(self, files):
        for i, data in enumerate(files.values()):
            (self.folder / f"{i:02d}.jpg").write_bytes(data)  # the extension does not matter
        names = [f"{i:02d}.jpg" for i in range(len(files))]
        lines = self.succeed("recognize", "--model", "./home.places", "--json", "-", *names)
        answers = [json.loads(line) for line in lines.splitlines()]
        self.assertEqual(len(answers), len(files))
        for kind, answer in zip(files, answers):
            with self.subTest(kind):
                self.assertEqual(answer["place"], "kitchen", answer)

    def test_jpeg(self):
        files = {kind: base64.b64decode(data) for kind, data in JPEGS.items()}
        image = paint("kitchen", 9)
        for kind, parameters in (("progressive", [cv2.IMWRITE_JPEG_PROGRESSIVE, 1]),
                                 ("restart markers", [cv2.IMWRITE_JPEG_RST_INTERVAL, 1]),
                                 ("coarse", [cv2.IMWRITE_JPEG_QUALITY, 8])):
            files[kind] = cv2.imencode(".jpg", image, parameters)[1].tobytes()
        whole = files["progressive"]
        files["an image behind it"] = whole + files["coarse"]
        files["no end marker"] = whole[:-2]
        comment = b"\xff\xfe\xff\xff" + b"x" * 65533
        files["long comments"] = whole[:2] + comment * 2 + whole[2:]
        self.assert_kitchen(files)

    def test_png(self):
        files = pngs(paint("kitchen", 9))
        deep = paint("kitchen", 9).astype(np.uint16) * 257
        files["16 bits"] = cv2.imencode(".png", deep)[1].tobytes()
        files["bytes behind it"] = files["16 bits"] + b"rubbish"
        self.assert_kitchen(files)

    def test_grey_kinds_are_read(self):
        grey = paint("kitchen", 9)[..., 1]
        pair = np.dstack([grey, np.full_like(grey, 200)]).reshape(96, -1)
        files = {"grey": png(grey, 8, 0), "grey half transparent": png(pair, 8, 4),
                 "two levels": png(np.packbits(grey > 128, axis=1), 1, 0),
                 "16 bits": png(np.repeat(grey, 2, axis=1), 16, 0)}
        for i, data in enumerate(files.values()):
            (self.folder / f"{i}.png").write_bytes(data)
        result = self.run_tool("recognize", "--model", "./home.places", *(f"{i}.png" for i in range(4)))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertNotIn("cannot be used", result.stdout + result.stderr)


if __name__ == "__main__":
    unittest.main()
