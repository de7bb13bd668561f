"""All documentation as one static site: build/site/index.html.

    python3 docs/tools/make_site.py [--out DIR]

Needs Sphinx, myst-parser, the theme furo, MathJax 2 and Doxygen (./dem docs installs them). Pages
are the Markdown files of the repository, where they are. Links to sources lead to copies with line
numbers. The report of the verification is included if ./dem verify has written it. Formulas and the
search need no network and no server. Warnings of Sphinx and Doxygen, and broken links, are errors:
exit code 1.
"""
import argparse
import html
import os
import posixpath
import re
import shutil
import subprocess
import sys
import urllib.parse
from pathlib import Path

import links
from links import ROOT

SETTINGS = Path(__file__).with_name("site")
#: Where MathJax 2 is: MATHJAX, Debian, Fedora, conda.
MATHJAX = (os.environ.get("MATHJAX"), "/usr/share/javascript/mathjax",
           os.environ.get("CONDA_PREFIX", "/nowhere") + "/lib/mathjax")
#: Order of docs/ in the side bar; what is not named stands at its end.
GUIDES = ("user-guide", "course", "developer-guide", "method")
EVIDENCE = ("deviations", "equations", "performance", "scaling")
#: Languages of code blocks that the highlighter does not know.
PLAIN = ("off", "csv")


def fail(message):
    """Ends the program: exit code 1."""
    sys.exit(f"site: {message}")


class Pages:
    """The Markdown files, prepared for Sphinx below a folder."""

    def __init__(self, folder):
        self.folder = folder
        self.sources = set()  # files that pages link to
        self.names = [path.relative_to(ROOT).as_posix() for path in links.markdown_files()]

    @staticmethod
    def staged(name):
        """Where a page is for Sphinx: the README is the front page."""
        return "index.md" if name == "README.md" else name

    def target(self, page, text, target):
        """A link of a page as the site needs it, Markdown or HTML; text is what it is called."""
        parts = urllib.parse.urlsplit(target)
        if parts.scheme or not parts.path:
            return f"[{text}]({target})"
        path = posixpath.normpath(posixpath.join(posixpath.dirname(page),
                                                 urllib.parse.unquote(parts.path)))
        if (ROOT / path / "README.md").is_file():
            path = posixpath.normpath(path + "/README.md")
        here = posixpath.dirname(self.staged(page)) or "."
        if path in self.names:
            to = posixpath.relpath(self.staged(path), here)
            return f"[{text}]({to}{'#' + parts.fragment if parts.fragment else ''})"
        if not (ROOT / path).is_file():
            fail(f"{page}: {target} is no page and no file")
        self.sources.add(path)
        line = re.match(r"L(\d+)", parts.fragment)
        to = posixpath.relpath(source_page(path), here) + (f"#L-{line[1]}" if line else "")
        return f'<a href="{to}">{text}</a>'

    def prepare(self, name):
        """Writes a page for Sphinx."""
        fence, lines = None, []
        for line in (ROOT / name).read_text(encoding="utf-8").splitlines():
            mark = links.FENCE.match(line)
            if fence:
                if mark and mark[1].startswith(fence) and not mark[2]:
                    fence = None
            elif mark:
                fence = mark[1]
                line = re.sub(r"(`{3,}|~{3,})\s*math$", r"\1{math}", line)
                line = re.sub(rf"(`{{3,}}|~{{3,}})\s*({'|'.join(PLAIN)})$", r"\1text", line)
            else:
                line = self.links_of(name, line)
            lines.append(line)
        to = self.folder / self.staged(name)
        to.parent.mkdir(parents=True, exist_ok=True)
        to.write_text("\n".join(lines) + "\n", encoding="utf-8")

    def links_of(self, name, line):
        """A line of text with its links as the site needs them."""
        def one(match):
            if match[0].startswith("!"):
                self.picture(name, match[1])
                return match[0]
            text = match[0][1:match[0].rindex("](")]
            inner = links.IMAGE_IN_LINK.search(text)
            if inner:
                self.picture(name, inner[1])
            return self.target(name, text, match[1])

        parts = re.split(r"(`+[^`]+`+)", line)  # code stays, but it may stand in a link
        hidden = "".join(f"\0{k}\0" if k % 2 else part for k, part in enumerate(parts))
        changed = links.LINK.sub(one, hidden)
        return re.sub(r"\0(\d+)\0", lambda match: parts[int(match[1])], changed)

    def picture(self, name, target):
        """Copies a picture of a page to where the page expects it."""
        path = posixpath.normpath(posixpath.join(posixpath.dirname(name), target))
        to = self.folder / posixpath.normpath(posixpath.join(
            posixpath.dirname(self.staged(name)), target))
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / path, to)

    def contents(self):
        """The side bar: [(title, [pages])]."""
        guides, evidence = ([f"docs/{name}.md" for name in names if f"docs/{name}.md" in self.names]
                            for names in (GUIDES, EVIDENCE))
        rest = [name for name in self.names
                if name.startswith("docs/") and name not in guides + evidence]

        def below(folder):  # a README before what is in its folder; advice for authors last
            return sorted((name for name in self.names if name.startswith(folder)), key=lambda name:
                          ("AUTHORING" in name, posixpath.dirname(name), "README" not in name))

        parts = [("Guides", guides), ("Scenes", below("tinydem/")),
                 ("Exercises", below("exercises/")),
                 ("Evidence", below("verification/") + evidence),
                 ("Reference", ["reference.md", *sorted(rest, reverse=True)])]
        listed = {name for _, these in parts for name in these}
        parts.append(("More", [name for name in self.names
                               if name not in listed and name != "README.md"]))
        return [(title, these) for title, these in parts if these]

    def write(self, report):
        """Writes all pages, with the side bar and the page of what was not made by Sphinx."""
        for name in self.names:
            self.prepare(name)
        verification = '- <a href="report/index.html">Report of the verification</a>: every ' \
            "claim with its figures" if report else \
            "- The report of the verification is not here: `./dem verify` writes it, then make " \
            "the site again"
        more = "\n- <a href=\"report/bench.html\">What a step costs</a>" \
            if "bench.html" in report else ""
        (self.folder / "reference.md").write_text(
            "# Report, reference, sources\n\n" + verification + more + "\n"
            '- <a href="api/namespacetinydem.html">Reference of the two files</a>: types, '
            'functions, members\n'
            '- <a href="source/tinydem/tinydem.cpp.html">tinydem.cpp</a>: the physics\n'
            '- <a href="source/tinydem/tinydem.hpp.html">tinydem.hpp</a>: the machinery\n')
        self.sources |= {"tinydem/tinydem.cpp", "tinydem/tinydem.hpp"}
        with open(self.folder / "index.md", "a", encoding="utf-8") as front:
            for title, pages in self.contents():
                front.write("\n```{toctree}\n:hidden:\n:caption: " + title + "\n\n")
                front.write("\n".join(name.removesuffix(".md") for name in pages) + "\n```\n")


def source_page(path):
    """Where the copy of a file is in the site; what is no text keeps its name."""
    kind = posixpath.splitext(path)[1]
    return f"source/{path}" + ("" if kind in (".png", ".gif", ".svg", ".pdf") else ".html")


def write_source(site, path):
    """A file with line numbers, each of which can be linked to: #L-12."""
    from pygments import highlight
    from pygments.formatters import HtmlFormatter
    from pygments.lexers import TextLexer, get_lexer_for_filename
    from pygments.util import ClassNotFound
    to = site / source_page(path)
    to.parent.mkdir(parents=True, exist_ok=True)
    if to.suffix != ".html":
        shutil.copy(ROOT / path, to)
        return
    try:
        lexer = get_lexer_for_filename(path)
    except ClassNotFound:
        lexer = TextLexer()
    look = HtmlFormatter(linenos="table", lineanchors="L", anchorlinenos=True, cssclass="code",
                         wrapcode=True)
    code = highlight((ROOT / path).read_text(encoding="utf-8"), lexer, look)
    front = posixpath.relpath("index.html", posixpath.dirname(source_page(path)))
    to.write_text(
        f"<!DOCTYPE html><html lang='en'><head><meta charset='utf-8'><title>{html.escape(path)}"
        "</title><meta name='viewport' content='width=device-width, initial-scale=1'><style>"
        f"{look.get_style_defs('.code')}\nbody {{ margin: 1rem; font: 15px/1.4 sans-serif; }}"
        ".codetable { overflow-x: auto; display: block; } pre { margin: 0; padding: 0 .5rem; }"
        "td.linenos a { color: #888; text-decoration: none; } :target { background: #ffec99; }"
        f"</style></head><body><p><a href='{front}'>TinyDEM</a> / {html.escape(path)}</p>"
        f"{code}</body></html>\n", encoding="utf-8")


def copy_mathjax(static):
    """The parts of MathJax that draw TeX as SVG."""
    for folder in MATHJAX:
        if folder and (Path(folder) / "MathJax.js").is_file():
            break
    else:
        fail("MathJax 2 is missing: apt install libjs-mathjax, or set MATHJAX to its folder")
    for part in ("MathJax.js", "config/TeX-AMS_SVG-full.js", "jax/output/SVG/fonts/TeX",
                 "jax/output/SVG/autoload", "jax/element", "jax/input/TeX", "extensions/TeX"):
        source, to = Path(folder) / part, static / "mathjax" / part
        to.parent.mkdir(parents=True, exist_ok=True)
        if source.is_dir():
            shutil.copytree(source, to)
        else:
            shutil.copy(source, to)


def run(*words, log):
    """Runs a program; what it says is shown if it fails."""
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, text=True,
                          stderr=subprocess.STDOUT, cwd=ROOT)
    log.write_text(done.stdout)
    if done.returncode != 0:
        fail(f"{words[0]} failed, {log}:\n{done.stdout}")


def build(site):
    """Makes the site; the folder of the same name with -pages behind it is for Sphinx."""
    pages = site.with_name(site.name + "-pages")
    for folder in (site, pages):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
    made = ROOT / "verification/report"
    report = [path.name for path in sorted(made.glob("*.html"))] \
        if (made / "index.html").is_file() else []
    stage = Pages(pages)
    stage.write(report)
    shutil.copy(SETTINGS / "conf.py", pages)
    (pages / "_static").mkdir()
    shutil.copy(SETTINGS / "tinydem.css", pages / "_static")
    copy_mathjax(pages / "_static")
    run(sys.executable, "-m", "sphinx", "-W", "--keep-going", "-q", "-b", "html", "-d",
        pages / ".doctrees", pages, site, log=pages / "sphinx.log")

    doxyfile = pages / "Doxyfile"
    doxyfile.write_text((SETTINGS / "Doxyfile").read_text() + f"OUTPUT_DIRECTORY = {site}\n"
                        "INPUT = tinydem/tinydem.hpp tinydem/tinydem.cpp\n")
    run("doxygen", doxyfile, log=pages / "doxygen.log")

    for path in sorted(stage.sources):
        write_source(site, path)
    for name in report:
        (site / "report").mkdir(exist_ok=True)
        shutil.copy(made / name, site / "report")
    return len(stage.names)


def main():
    """The program; see the top of this file."""
    arguments = argparse.ArgumentParser(description="Make the site of the documentation.")
    arguments.add_argument("--out", metavar="DIR", default=str(ROOT / "build/site"),
                           help="where to; replaced (default: build/site)")
    site = Path(arguments.parse_args().out).resolve()
    if site.exists() and any(site.iterdir()) and not (site / "searchindex.js").exists():
        fail(f"{site} holds something else; name another folder")
    count = build(site)
    faults, checked = links.check_site(site)
    if faults:
        fail("broken links:\n" + "\n".join(faults))
    print(f"site: {count} pages, {checked} links are good: {site / 'index.html'}")


if __name__ == "__main__":
    main()
