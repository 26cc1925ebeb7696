#!/usr/bin/env python3
"""Checks that index.html of the label page has every id that its scripts and its tests look up.

check_page_ids.py ROOT    The tests of the page itself are skipped without a browser.
"""
import pathlib
import re
import sys

LOOKED_UP = re.compile(r"""(?:element|getElementById|text)\(\s*["']([a-z-]+)["']"""
                       r"""|(?:querySelector|querySelectorAll)\(\s*["'`]\#([a-z-]+)""")


def main(root):
    page = root / 'label_page/page'
    ids = set(re.findall(r'\sid="([^"]+)"', (page / 'index.html').read_text(encoding='utf-8')))
    users = sorted(page.glob('*.js')) + [root / 'test/tool' / name for name in
                                         ('page_case.py', 'label_page_test.py')]
    missing = []
    for user in users:
        for match in LOOKED_UP.finditer(user.read_text(encoding='utf-8')):
            name = match.group(1) or match.group(2)
            if name not in ids:
                missing.append(f'{user.relative_to(root)}: index.html has no id "{name}"')
    print('\n'.join(missing) or f'{len(ids)} ids, {len(users)} files that look them up')
    return 1 if missing else 0


if __name__ == '__main__':
    sys.exit(main(pathlib.Path(sys.argv[1])))
