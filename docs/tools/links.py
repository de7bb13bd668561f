"""Check links: of all Markdown files of the repository, and of a rendered site. No network.

    python3 docs/tools/links.py              every Markdown file
    python3 docs/tools/links.py --site DIR   every HTML file below DIR

A link to a file or folder needs the file, in the same upper and lower case; one with #anchor needs
a heading (or id) of that name; #L12 of a source file needs twelve lines; an image needs its file.
Addresses on the web are only checked to be http(s) or mailto. Exit code 0: all good, 1: broken
links, one line each.
"""
import argparse
import html.parser
import re
import sys
import urllib.parse
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
#: Folders at the root of the repository that hold nothing of its own.
NOT_OURS = ("build", "output")
#: What a link on the web starts with.
WEB = ("http", "https", "mailto")

FENCE = re.compile(r"^\s*(`{3,}|~{3,})\s*(.*)$")
LINK = re.compile(r"""!?\[(?:[^\[\]]|\[[^\]]*\](?:\([^)]*\))?)*\]
                      \(\s*<?([^()\s<>]*(?:\([^()]*\)[^()\s]*)*)>?(?:\s+"[^"]*")?\s*\)""", re.X)
IMAGE_IN_LINK = re.compile(r'!\[[^\]]*\]\(\s*([^()\s]+)(?:\s+"[^"]*")?\s*\)')
DEFINITION = re.compile(r"^\s{0,3}\[([^\]]+)\]:\s*<?([^>\s]+)>?")
REFERENCE = re.compile(r"(?<![\]\w`])\[([^\[\]]+)\]\[([^\[\]]*)\]")


def markdown_files(root=ROOT):
    """Paths of the Markdown files of a repository: no build trees, no hidden folders."""
    for path in sorted(root.rglob("*.md")):
        inside = path.relative_to(root).parts
        if inside[0] not in NOT_OURS and not any(part.startswith(".") for part in inside):
            yield path


def prose(text):
    """(number from 1, line) of the lines outside of code blocks; code spans are blanked."""
    fence = None
    for number, line in enumerate(text.splitlines(), 1):
        mark = FENCE.match(line)
        if fence:
            if mark and mark[1].startswith(fence) and not mark[2]:
                fence = None
            continue
        if mark:
            fence = mark[1]
            continue
        yield number, re.sub(r"(`+)(.+?)\1", lambda code: code[1] + " " * len(code[2]) + code[1],
                             line)


def slug(heading):
    """The anchor that GitHub makes of the text of a heading."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)  # links: their text
    text = re.sub(r"\\(.)", r"\1", re.sub(r"[`*]|(?<!\w)_|_(?!\w)", "", text)).strip().lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def anchors(text):
    """All anchors of a Markdown text: headings, repeated ones numbered, and ids in HTML."""
    found, seen = set(), {}
    code = {number for number, _ in prose(text)}
    for number, line in enumerate(text.splitlines(), 1):
        if number not in code:
            continue
        found.update(re.findall(r"""<[^>]*\b(?:id|name)=["']([^"']+)""", line))
        heading = re.match(r"#{1,6}\s+(.*?)\s*#*$", line)
        if heading:
            name = slug(heading[1])
            seen[name] = seen.get(name, -1) + 1
            found.add(f"{name}-{seen[name]}" if seen[name] else name)
    return found


def targets(text):
    """(line number, target) of every link and image of a Markdown text; a reference that is never
    defined gives the target None."""
    lines = list(prose(text))
    defined = {match[1].lower(): match[2] for _, line in lines
               if (match := DEFINITION.match(line))}
    for number, line in lines:
        for target in sorted({match[1] for expression in (LINK, IMAGE_IN_LINK)
                              for match in expression.finditer(line)}):
            yield number, target
        for target in re.findall(r"""<(?:a|img|source)\b[^>]*\b(?:href|src)=["']([^"']+)""", line):
            yield number, target
        for match in REFERENCE.finditer(line):
            yield number, defined.get((match[2] or match[1]).lower())
        if DEFINITION.match(line):
            yield number, DEFINITION.match(line)[2]


def exists(path):
    """Is there a file or folder of exactly this name? Upper and lower case count everywhere."""
    return path.exists() and (path.name in ("", "..") or
                              path.name in {entry.name for entry in path.parent.iterdir()})


def fault(page, target, root=ROOT):
    """What is wrong with a link of a Markdown page, or None."""
    if target is None:
        return "a reference that is not defined"
    parts = urllib.parse.urlsplit(target)
    if parts.scheme or target.startswith("//"):
        return None if parts.scheme in WEB else f"'{parts.scheme}' is no way to reach a page"
    path = page
    if parts.path:
        path = Path(urllib.parse.unquote(parts.path))
        if path.is_absolute():
            return "is absolute; write it relative to this file"
        path = (page.parent / path).resolve()
        if not path.is_relative_to(root):
            return "leaves the repository"
        if not exists(path):
            return "there is no such file"
    if not parts.fragment:
        return None
    if path.is_dir():
        return "an anchor needs a file, this is a folder"
    fragment = urllib.parse.unquote(parts.fragment)
    if path.suffix == ".md":
        return None if fragment in anchors(path.read_text(encoding="utf-8")) else \
            f"no heading there has the anchor #{fragment}"
    line = re.fullmatch(r"L(\d+)(?:-L(\d+))?", fragment)
    if not line:
        return "in a source file only #L12 or #L12-L15 can be reached"
    count = len(path.read_text(encoding="utf-8").splitlines())
    return None if int(line[2] or line[1]) <= count else f"the file has {count} lines only"


def check_markdown(root=ROOT):
    """(faults, number of links) of all Markdown files; a fault is a line file:line: target: why."""
    faults, count = [], 0
    for page in markdown_files(root):
        for number, target in targets(page.read_text(encoding="utf-8")):
            count += 1
            why = fault(page.resolve(), target, root.resolve())
            if why:
                faults.append(f"{page.relative_to(root)}:{number}: {target}: {why}")
    return faults, count


# --------------------------------------------------------------------------------- rendered site

class Page(html.parser.HTMLParser):
    """Collects what a page links to, (tag, target), and the names that one can link to."""

    def __init__(self, text):
        super().__init__()
        self.links, self.names, self.base = [], {"", "top"}, False
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        """Called for every tag."""
        values = dict(attributes)
        self.names.update(values[key] for key in ("id", "name") if values.get(key))
        for key in ("href", "src", "data"):
            if values.get(key) is not None and (key != "data" or tag == "object"):
                self.links.append((tag, values[key]))
        for source in (values.get("srcset") or "").split(","):
            if source.strip():
                self.links.append((tag, source.split()[0]))


def check_site(site):
    """(faults, number of links) of all HTML files below a folder."""
    site = Path(site).resolve()
    pages = {path: Page(path.read_text(encoding="utf-8", errors="replace"))
             for path in sorted(site.rglob("*.html"))}
    faults, count, known = [], 0, {}
    for path, page in pages.items():
        for tag, target in page.links:
            parts = urllib.parse.urlsplit(target)
            if parts.scheme or target.startswith("//"):
                embedded = tag in ("img", "script", "link") and parts.scheme != "data"
                if embedded and tag != "link":
                    faults.append(f"{path.relative_to(site)}: {target}: is not part of the site")
                continue
            count += 1
            to = path if not parts.path else path.parent / urllib.parse.unquote(parts.path)
            to = Path(*to.parts)
            if to not in known:
                known[to] = to.exists()
            if not known[to]:
                faults.append(f"{path.relative_to(site)}: {target}: there is no such file")
                continue
            to = to.resolve()
            if to.is_dir():
                faults.append(f"{path.relative_to(site)}: {target}: is a folder; name a page")
            elif to in pages and parts.fragment and \
                    urllib.parse.unquote(parts.fragment) not in pages[to].names:
                faults.append(f"{path.relative_to(site)}: {target}: no such anchor")
    return faults, count


def main():
    """The program; see the top of this file."""
    arguments = argparse.ArgumentParser(description="Check the links of Markdown files or a site.")
    arguments.add_argument("--site", metavar="DIR", help="check the HTML files below this folder")
    arguments.add_argument("--root", metavar="DIR", default=ROOT, help="another repository")
    given = arguments.parse_args()
    faults, count = check_site(given.site) if given.site else check_markdown(Path(given.root))
    for line in faults:
        print(line)
    print(f"links: {count} checked, {len(faults)} broken")
    return 1 if faults or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
