"""Draws impact.png: python3 exercises/02-damping-and-restitution/figures.py"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "verification"))
import numpy as np  # noqa: E402
import style  # noqa: E402


def impact(en, clipped=False, steps=4000):
    """Overlap, force and time of an impact with m* = K = v = 1 (k_n = K sqrt(delta))."""
    loss = -np.log(en)
    beta = loss / np.hypot(np.pi, loss)
    deepest = 1.25 ** 0.4
    dt = 2.94 * deepest / steps
    delta, v, t, line = 1e-9, -1.0, 0.0, []
    while delta > 0:
        kn = np.sqrt(delta)
        f = kn * delta - beta * np.sqrt(5 * kn) * v
        f = max(f, 0) if clipped else f
        v += dt * f
        line.append((t, delta, f))
        delta -= dt * v
        t += dt
    return np.array(line).T, v


if __name__ == "__main__":
    fig, axes = style.figure(1, 2, width=3.7)
    for k, en in enumerate((1.0, 0.7, 0.4)):
        (t, delta, f), _ = impact(en)
        axes[0].plot(delta, f, **style.cycle(k, marker=False), label=f"$e_n$ = {en:g}")
    axes[0].axhspan(-1, 0, color="0.93", zorder=0)
    axes[0].annotate("attraction", (0.33, -0.17), ha="center", fontsize=8)
    axes[0].annotate("approach", (0.42, 0.76), fontsize=8, rotation=17)
    axes[0].annotate("parting", (0.6, 0.1), fontsize=8, rotation=38)
    axes[0].set(xlim=(0, 1.15), ylim=(-0.4, 1.4))
    style.label(axes[0], r"overlap $\delta$ ($m^* = K = v = 1$)", "normal force",
                "force and overlap during an impact")
    axes[0].legend(loc="upper left")
    wanted = np.linspace(0.02, 1, 25)
    axes[1].plot(wanted, [impact(e, steps=1000)[1] for e in wanted], **style.cycle(0, marker=False),
                 label="as in Eq. (5)")
    axes[1].plot(wanted, [impact(e, True, steps=1000)[1] for e in wanted],
                 **style.cycle(1, marker=False), label="attraction cut off")
    axes[1].set(xlim=(0, 1), ylim=(0, 1))
    style.label(axes[1], "$e_n$ asked for", "$e$ measured", "what the tail is good for")
    axes[1].legend(loc="upper left")
    fig.savefig(HERE / "impact.png", metadata={"Software": None})
