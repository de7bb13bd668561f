"""Figure of case 12: error of velocities and spins after the impact over force evaluations."""
import style

TITLES = {"equal": "equal spheres, no spin, $e_n$ = 1",
          "elastic": "radii 10 and 6 mm, spins, $e_n$ = 1",
          "damped": "slides and rolls all the time, $e_n$ = 0.5",
          "sticking": "sliding dies, $e_n$ = 0.8 (not judged)"}


def draw(data, out):
    table = style.read(data / "convergence.csv")
    fig, axes = style.figure(2, 2, height=2.5)
    for ax, (name, title) in zip(axes.flat, TITLES.items()):
        part = style.where(table, name=name)
        for method in dict.fromkeys(part["method"]):
            rows = style.where(part, method=method)
            ax.loglog(rows["force_evaluations"], rows["error"], **style.LINE[method], label=method)
        ax.set_ylim(1e-8, 2)
        if name != "sticking":
            style.ideal(ax, 1, 20, 3e-5)
        style.label(ax, "force evaluations", "rms error (of the relative speed)", title)
    axes[1][1].legend(loc="lower left")
    style.save(fig, out, "12_pair_3d")
