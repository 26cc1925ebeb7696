"""Checks the documents: check_documents.py ROOT.

Links lead to files and headings that exist, and so do the source files and tests that the text
names in `code`.
"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
documents = sorted(root.glob("*.md")) + sorted((root / "doc").glob("*.md"))
sources = [path for folder in ("include", "src", "test", "benchmark", "scripts", "label_page")
           for path in (root / folder).rglob("*")]
names = {path.name for path in sources}
stems = {path.stem for path in sources}


def without_code_blocks(text):
    return re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)


def anchors(path):
    """The anchors of a page's headings, as code hosts make them."""
    headings = re.findall(r"^#+ +(.*)$", without_code_blocks(path.read_text()), flags=re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def problems(path):
    text = without_code_blocks(path.read_text())
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if re.match(r"[a-z]+:", target):
            continue
        name, _, anchor = target.partition("#")
        page = path.parent / name if name else path
        if not page.exists():
            yield f"the link to {target} leads nowhere"
        elif anchor and anchor not in anchors(page):
            yield f"{page.name} has no heading #{anchor}"
    for code in re.findall(r"`([^`\n]+)`", text):
        if re.fullmatch(r"(src|include|test|doc|scripts|config|benchmark|experiments|launch)/[\w./]+", code):
            if not (root / code).exists():
                yield f"there is no {code}"
        elif re.fullmatch(r"[a-z]\w+\.(cpp|h)", code) and code not in names:
            yield f"no source file is named {code}"
        elif re.fullmatch(r"[a-z]\w+_(ros)?test", code) and code not in stems:
            yield f"no test is named {code}"


found = [f"{path.relative_to(root)}: {problem}" for path in documents for problem in problems(path)]
print("\n".join(found))
print(f"{len(documents)} documents looked at")
sys.exit(1 if found else 0)
