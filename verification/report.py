"""The report: one page that needs no other file. Summary first, then a chapter per case."""
import base64
import html
import math
import re
import textwrap
from datetime import date
from pathlib import Path

import style

LEVELS = (0.1, 0.01, 0.001)
SCHEMES = ("consistent", "paper")
CSS = """
body { font: 16px/1.5 Georgia, 'DejaVu Serif', serif; color: #1a1a1a; max-width: 58rem;
       margin: 2rem auto; padding: 0 1rem; }
h1, h2, h3, th, nav, .tag, figcaption { font-family: 'Helvetica Neue', Arial, sans-serif; }
h1 { font-size: 1.9rem; margin-bottom: .2rem; } h2 { margin-top: 3rem; border-top: 1px solid #bbb;
padding-top: 1rem; } table { border-collapse: collapse; font-size: .84rem; margin: 1rem 0; }
th, td { border-bottom: 1px solid #ddd; padding: .25rem .55rem; text-align: left;
vertical-align: top; } td.n, th.n { text-align: right; font-variant-numeric: tabular-nums;
white-space: nowrap; } td.c, th.c { text-align: center; padding: .2rem .28rem; }
thead th { border-bottom: 2px solid #555; } figure { margin: 1.2rem 0; } img { max-width: 100%; }
code { font-size: .87em; background: #f3f3f3; padding: 0 .2em; } .fail { font-weight: bold;
background: #222; color: #fff; padding: 0 .3em; } .tag { font-size: .75rem; border: 1px solid #999;
border-radius: 3px; padding: 0 .35em; margin-right: .3em; white-space: nowrap; }
nav ol { columns: 2; font-size: .9rem; padding-left: 0; list-style: none; }
.wide { overflow-x: auto; }
.lead { color: #444; font-size: 1.05rem; } figcaption { font-size: .8rem; color: #444; }
@media print { h2 { break-before: page; } figure, table { break-inside: avoid; } }
"""


def light(text):
    """Markdown-light: paragraphs, lists, `code`, **bold**, *italics*; entities, sub, sup pass."""
    def inline(s):
        s = re.sub(r"&(?!#?\w+;)", "&amp;", s).replace("<", "&lt;").replace(">", "&gt;")
        s = re.sub(r"&lt;(/?(?:su[bp]|[bi]))&gt;", r"<\1>", s)
        parts = re.split(r"`([^`]+)`", s)
        for k in range(0, len(parts), 2):
            parts[k] = re.sub(r"\*\*(.+?)\*\*", r"<b>\1</b>", parts[k], flags=re.S)
            parts[k] = re.sub(r"(?<![\w*])\*(?!\s)(.+?)(?<!\s)\*(?!\w)", r"<i>\1</i>", parts[k],
                              flags=re.S)
        for k in range(1, len(parts), 2):
            parts[k] = f"<code>{parts[k]}</code>"
        return "".join(parts)
    blocks = []
    for block in re.split(r"\n\s*\n", text.strip()):
        if re.match(r"\s*[-*] ", block):
            items = re.split(r"\n\s*[-*] ", "\n" + block.strip())[1:]
            blocks.append("<ul>" + "".join(f"<li>{inline(i)}</li>" for i in items) + "</ul>")
        else:
            blocks.append(f"<p>{inline(block)}</p>")
    return "\n".join(blocks)


def number(value, digits=3):
    """A number for people: 0.0123, 4.5e-12 as 4.5 x 10^-12."""
    if value is None or value != value:
        return "&ndash;"
    if value == 0 or 1e-3 <= abs(value) < 1e5:
        whole = f"{float(f'{value:.{digits}g}'):.0f}"
        return whole if abs(value) >= 10 ** (digits - 1) else f"{value:.{digits}g}"
    mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
    return f"{mantissa}&middot;10<sup>{int(exponent)}</sup>".replace("-", "&minus;")


def table(head, rows, classes):
    """rows of cells (HTML); classes: one per column, n = number, c = centred."""
    def line(cells, tag):
        return "<tr>" + "".join(f"<{tag} class='{k}'>{c}</{tag}>"
                                for c, k in zip(cells, classes)) + "</tr>"
    return "<div class='wide'><table><thead>" + line(head, "th") + "</thead><tbody>" + \
        "\n".join(line(r, "td") for r in rows) + "</tbody></table></div>"


def image(path, caption=""):
    """A figure inside the page: SVG, or PNG where the SVG is large."""
    svg, png = path.with_suffix(".svg"), path.with_suffix(".png")
    small = svg.exists() and (svg.stat().st_size < 400_000 or not png.exists())
    data, kind = (svg, "svg+xml") if small else (png, "png")
    code = base64.b64encode(data.read_bytes()).decode()
    return f"<figure><img alt='{html.escape(caption)}' src='data:image/{kind};base64,{code}'>" \
           f"<figcaption>{html.escape(caption)}</figcaption></figure>"


# -------------------------------------------------------------------------------- work, error

def reach(work, method, level):
    """The largest step (and its evaluations) from which on the error stays at or below `level`;
    interpolated in the logarithms between the measured steps; and whether it is the coarsest step
    that was tried, so that a larger one may do. None: never."""
    rows = style.where(work, method=method)
    points = sorted(zip(rows["dt_over_eq50"], rows["error"], rows["force_evaluations"]))
    best = None
    for k, (step, error, cost) in enumerate(points):
        if not error <= level:
            if best is None or error <= 0:
                return best and (*best, False)
            small, low, dear = points[k - 1]
            low = max(low, 1e-300)
            share = math.log(level / low) / math.log(error / low) if error > low else 0
            return small * (step / small) ** share, dear * (cost / dear) ** share, False
        best = step, cost
    return best and (*best, True)


def load_work(cases, folder):
    paths = {c["id"]: folder / "data" / c["id"] / "work.csv" for c in cases}
    return {i: style.read(p) for i, p in paths.items() if p.exists()}


def step_table(cases, works):
    head = ["case"] + [f"{scheme}<br>{100 * l:g} %" for scheme in SCHEMES for l in LEVELS] + \
        ["cost ratio<br>at 1 %"]
    rows = []
    for case in cases:
        if case["id"] not in works:
            continue
        found = [[reach(works[case["id"]], s, l) if s in works[case["id"]]["method"] else None
                  for l in LEVELS] for s in SCHEMES]
        cells = [("&ge; " if r[2] else "") + f"{number(r[0], 2)}<br><small>"
                 f"{'&le; ' if r[2] else ''}{number(r[1], 2)}</small>" if r else "&ndash;"
                 for scheme in found for r in scheme]
        here, there = found[0][1], found[1][1]
        ratio = "&ndash;" if not here or there and there[2] else "&infin;" if not there else \
            ("&ge; " if here[2] else "") + f"{there[1] / here[1]:.1f}"
        rows.append([f"<a href='#{case['id']}'>{html.escape(case['title'])}</a>", *cells, ratio])
    return table(head, rows, [""] + ["n"] * 7)


def step_figure(cases, works, folder):
    """Largest step for each level of error; one row per case, scheme beside scheme."""
    shown = [c for c in cases if c["id"] in works][::-1]
    if not shown:
        return ""
    fig, axes = style.plt.subplots(1, len(LEVELS), sharey=True,
                                   figsize=(7.4, 1.0 + 0.24 * len(shown)))
    for ax, level in zip(axes, LEVELS):
        for scheme, lift in zip(SCHEMES, (0.14, -0.14)):
            line = {**style.LINE[scheme], "linestyle": "none"}
            points = [(reach(works[c["id"]], scheme, level), k) for k, c in enumerate(shown)
                      if scheme in works[c["id"]]["method"]]
            ax.semilogx([p[0] for p, _ in points if p], [k + lift for p, k in points if p], **line,
                        label=scheme)
        ax.axvline(1, color="0.5", linewidth=0.8)
        style.label(ax, "step / step of Eq. (50)", "", f"error {100 * level:g} %")
        low, high = ax.get_xlim()
        ax.set_xlim(min(low, 0.08), max(high, 12))
        ax.xaxis.set_minor_formatter(style.plt.NullFormatter())
    names = [textwrap.shorten(c["title"], 48, placeholder=" ...") for c in shown]
    axes[0].set_yticks(range(len(shown)), names)
    axes[0].set_ylim(-0.6, len(shown) - 0.4)
    axes[0].legend(loc="upper right", bbox_to_anchor=(-0.06, -0.02), borderaxespad=0)
    style.save(fig, folder, "00_choose_your_step")
    return image(folder / "00_choose_your_step.svg",
                 "The largest step that keeps the error of each case below the level; "
                 "no mark: never")


def summary(cases, folder):
    works = load_work(cases, folder)
    return f"""<h2 id='step'>Choose your step</h2>
<p>How large may the time step be? For every case that evolves in time: the largest step, in units
of the default, Eq. (50), that keeps the error against the reference below 10 %, 1 % and 0.1 %, and
below it the number of evaluations of the contact force that this costs. A dash: not reached with
any step that was tried; mostly because the method tends to something else than the reference.
With &ge;, even the coarsest step that was tried is good enough. The last column is the cost of the
printed update of the friction springs over that of the consistent one, for an error of 1 %
(&infin;: not reached).</p>
{step_table(cases, works)}
{step_figure(cases, works, folder)}"""


# ------------------------------------------------------------------------------------ matrices

def short(case):
    return f"<a href='#{case['id']}' title='{html.escape(case['title'])}'>" \
           f"{int(case['id'][:2])}</a>"


def feature_matrix(cases):
    features = list(dict.fromkeys(word for c in cases for word in c["features"]))
    features.sort(key=lambda f: -sum(f in c["features"] for c in cases))
    rows = [[html.escape(f)] + ["&#9679;" if f in c["features"] else "" for c in cases]
            for f in features]
    equations = {}
    for case in cases:
        for e in case["equations"]:
            equations.setdefault(str(e), []).append(short(case))
    order = sorted(equations, key=lambda e: [int(n) for n in re.findall(r"\d+", e)] or [999])
    listed = "; ".join(f"<b>({e})</b> {', '.join(equations[e])}" for e in order)
    return "<h2 id='features'>Feature &times; case</h2>" + \
        table(["feature", *map(short, cases)], rows, [""] + ["c"] * len(cases)) + \
        f"<p>Equations of the paper, and the cases that check them: {listed}.</p>"


def kill_matrix(cases, kills):
    head = "<h2 id='mutants'>Mutant &times; case</h2>"
    if not kills:
        return head + "<p>Not run yet: <code>./dem verify --mutants</code>.</p>"
    def cell(reason):
        why = html.escape(" ".join(reason.split())[:160])
        return f"<span title='{why}'>&#9679;</span>" if reason else ""
    rows = [[f"<code>{html.escape(k['id'])}</code><br>{html.escape(k['what'])}"] +
            [cell(k["kills"].get(c["id"], "")) for c in cases] for k in kills]
    dead = sum(any(k["kills"].values()) for k in kills)
    return head + f"""<p>A check that cannot fail checks nothing. Each row is the solver with one
statement made wrong; a dot marks a case that then fails. {dead} of {len(kills)} mutants are
noticed.</p>""" + table(["mutant", *map(short, cases)], rows, [""] + ["c"] * len(cases))


# ------------------------------------------------------------------------------------ chapters

def metric_table(case, result, states):
    rows = []
    for m in case["metric"]:
        sign = {"below": "&le;", "above": "&ge;", "equal": "="}[m.get("kind", "below")]
        state = states[m["name"]]
        rows.append([light(m["meaning"])[3:-4], number(result["metrics"].get(m["name"])),
                     f"{sign} {number(m['tolerance'])}", light(m["reason"])[3:-4],
                     state if state == "pass" else f"<span class='fail'>{state}</span>"])
    judged = {m["name"] for m in case["metric"]}
    others = ", ".join(f"<code>{html.escape(name)}</code> = {number(value)}"
                       for name, value in result["metrics"].items() if name not in judged)
    return table(["measured quantity", "value", "tolerance", "why this tolerance", ""], rows,
                 ["", "n", "n", "", ""]) + (f"<p><small>Not judged: {others}.</small></p>"
                                            if others else "")


def chapter(case, result, states, folder):
    tags = "".join(f"<span class='tag'>{html.escape(f)}</span>" for f in case["features"])
    figures = "".join(image(folder / f"{Path(f).stem}.svg", f"Figure {Path(f).stem}")
                      for f in case["figures"])
    equations = ", ".join(f"({e})" for e in case["equations"])
    return f"""<h2 id='{case['id']}'>{int(case['id'][:2])}&ensp;{html.escape(case['title'])}</h2>
<p class='lead'>{light(case['shows'])[3:-4]}</p>
<p>{tags} <small>Reference: {html.escape(case['reference'])}. Eqs. {equations}.
Measured in {result['seconds']:.1f} s.</small></p>
{light(case['text'])}
{figures}
{metric_table(case, result, states)}"""


def page(cases, results, states, kills, folder):
    bad = [c["id"] for c in cases if any(s != "pass" for s in states[c["id"]].values())]
    count = sum(len(c["metric"]) for c in cases)
    verdict = f"All {count} metrics of {len(cases)} cases are within their tolerances." if not bad \
        else f"<span class='fail'>Not all metrics pass:</span> {', '.join(bad)}."
    contents = "".join(f"<li><a href='#{c['id']}'>{int(c['id'][:2])}&ensp;"
                       f"{html.escape(c['title'])}</a></li>" for c in cases)
    chapters = "\n".join(chapter(c, results[c["id"]], states[c["id"]], folder) for c in cases)
    return f"""<!DOCTYPE html>
<html lang='en'><head><meta charset='utf-8'><title>TinyDEM: verification</title>
<meta name='viewport' content='width=device-width'><style>{CSS}</style></head><body>
<h1>TinyDEM: verification</h1>
<p class='lead'>Every claim checked against a reference that does not use the solver, drawn, and
able to fail. {verdict}</p>
<p><small>Written {date.today().isoformat()} by <code>./dem verify</code>. Equation numbers:
R. Vetter, Comput. Phys. Commun. (2025) 109942. <code>consistent</code> and <code>paper</code> are
the two updates of the friction springs, see docs/deviations.md.</small></p>
{"<p><a href='bench.html'>What a step costs</a></p>" if (folder / "bench.html").exists() else ""}
<nav><ol><li><a href='#step'>Choose your step</a></li><li><a href='#features'>Feature &times;
case</a></li><li><a href='#mutants'>Mutant &times; case</a></li>{contents}</ol></nav>
{summary(cases, folder)}
{feature_matrix(cases)}
{kill_matrix(cases, kills)}
{chapters}
</body></html>
"""
