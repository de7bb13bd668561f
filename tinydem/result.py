"""What a scene's measure.py reports: quantities with error bars, as text, result.csv and a figure.

    outputs, where = result.arguments(__doc__)   # measure.py OUTPUT [OUTPUT ...] [--out DIR]
    report = result.Report(where)
    report.add("angle of repose", 31.2, 0.4, "deg", expected="about 30")
    fig, ax = result.figure(1, 2)
    ...
    report.save(fig)                             # prints, writes result.csv and result.png
"""
import argparse
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of the backend)
import numpy as np  # noqa: E402

from frames import fail, read_run  # noqa: E402

# The look of the figures in verification/style.py.
PANEL = (3.35, 2.65)  # inches
COLORS = ["#00429d", "#d1495b", "#3d8f5f", "#8a5fb0", "#e39a1f", "#4fb3d9", "#7a7a7a"]
GRAINS = "#f5b229"  # gold, as in the pictures
plt.rcParams.update({
    "font.family": "DejaVu Sans", "font.size": 8.5, "mathtext.fontset": "dejavusans",
    "axes.titlesize": 9, "axes.labelsize": 8.5, "legend.fontsize": 7.5, "xtick.labelsize": 7.5,
    "ytick.labelsize": 7.5, "lines.linewidth": 1.4, "lines.markersize": 4.2,
    "axes.linewidth": 0.7, "axes.grid": True, "grid.color": "0.88", "grid.linewidth": 0.5,
    "axes.axisbelow": True, "legend.framealpha": 0.9, "legend.edgecolor": "0.8",
    "legend.fancybox": False, "savefig.dpi": 170, "figure.constrained_layout.use": True,
    "axes.prop_cycle": plt.cycler(color=COLORS),
})


def arguments(description):
    """The runs (as frames.read_run gives them) that the command line names, and where to write."""
    parser = argparse.ArgumentParser(description=description.splitlines()[0])
    parser.add_argument("outputs", nargs="+", type=Path, metavar="OUTPUT", help="folder of a run")
    parser.add_argument("--out", type=Path, help="where to write, default: the first OUTPUT")
    args = parser.parse_args()
    return [read_run(folder) for folder in args.outputs], args.out or args.outputs[0]


def mean_error(values):
    """Mean and its standard error; the error of a single value is unknown: nan."""
    values = np.asarray(values, float)
    error = values.std(ddof=1) / np.sqrt(len(values)) if len(values) > 1 else np.nan
    return values.mean() if len(values) else np.nan, error


def share_error(hits, trials):
    """Share of hits and its standard error (Wilson), which is not zero for 0 or all hits."""
    p = hits / trials
    return p, np.sqrt(p * (1 - p) * trials + 0.25) / (trials + 1)


def text(value, error):
    """A value with as many digits as its error deserves: 31.2 +- 0.4."""
    if not np.isfinite(error) or error <= 0:
        return f"{value:.4g}"
    digits = 1 - int(np.floor(np.log10(error)))
    if digits > 6 or digits < -3:
        return f"{value:.6g} +- {error:.2g}"
    return f"{value:.{max(digits, 0)}f} +- {error:.{max(digits, 0)}f}"


def figure(rows=1, columns=1, width=PANEL[0], height=PANEL[1]):
    """A figure of panels, inches per panel; axes as from plt.subplots."""
    return plt.subplots(rows, columns, figsize=(columns * width, rows * height))


def label(ax, x, y, title=None):
    """Labels, with units, of a panel."""
    ax.set_xlabel(x)
    ax.set_ylabel(y)
    if title:
        ax.set_title(title, loc="left")


class Report:
    """Quantities that a run gave, to be printed and kept in result.csv."""

    def __init__(self, folder):
        """folder: where to write."""
        self.folder, self.rows = Path(folder), []

    def add(self, quantity, value, error=np.nan, unit="", expected=""):
        """A quantity with its standard error (nan: not known) and what theory or others say."""
        self.rows.append((quantity, float(value), float(error), unit, str(expected)))

    def save(self, fig=None):
        """Print the quantities, write result.csv and the figure as result.png."""
        lines = ["quantity,value,error,unit,expected"]
        for quantity, value, error, unit, expected in self.rows:
            unit_text = f" {unit}" if unit else ""
            note = f"  (expected {expected})" if expected else ""
            print(f"{quantity} = {text(value, error)}{unit_text}{note}")
            lines.append(f'"{quantity}",{value:.8g},{error:.3g},{unit},"{expected}"')
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            (self.folder / "result.csv").write_text("\n".join(lines) + "\n")
            if fig is not None:
                fig.savefig(self.folder / "result.png", metadata={"Software": None})
                plt.close(fig)
        except OSError as error:
            fail(f"{self.folder}: cannot be written ({error.strerror}); try: --out DIR")
