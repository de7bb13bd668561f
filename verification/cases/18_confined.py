"""How many contacts each confined scene has seen, and how many numbers left their place."""
import numpy as np
import style


def draw(data, out):
    rows = style.read(data / "confined.csv")
    where, walls = list(dict.fromkeys(rows["where"])), list(dict.fromkeys(rows["walls"]))
    fig, axes = style.figure(1, 2, height=2.9)
    for ax, scheme in zip(axes, ("consistent", "paper")):
        table, left = np.zeros((len(walls), len(where))), np.zeros((len(walls), len(where)))
        for w, wall, s, gone, pairs, hits in zip(*(rows[k] for k in rows)):
            if s == scheme:
                table[walls.index(wall), where.index(w)] = pairs + hits
                left[walls.index(wall), where.index(w)] = gone
        ax.imshow(np.log10(table + 1), cmap="Greys", vmin=1, vmax=7, aspect="auto")
        for (y, x), n in np.ndenumerate(table):
            ax.text(x, y, f"{n:.0f}\n{left[y, x]:.0f}", ha="center", va="center", fontsize=7)
        names = [f"{w} {'plane' if len(w) > 1 else 'axis'}" for w in where]
        ax.set_xticks(range(len(where)), names, rotation=30)
        ax.set_yticks(range(len(walls)), walls)
        ax.grid(False)
        style.label(ax, "", "walls made of", f"{scheme}: contacts, departures")
    style.save(fig, out, "18_confined")
