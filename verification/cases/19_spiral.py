"""Order of the orientation under three torques, the two-axes test, fast spin, norm."""
import numpy as np
import style


def draw(data, out):
    rows, fast = style.read(data / "order.csv"), style.read(data / "fast.csv")
    axes, norm = style.read(data / "two_axes.csv"), style.read(data / "norm.csv")
    fig, ax = style.figure(2, 2)
    a = ax[0][0]
    for k, torque in enumerate(("parallel", "skew", "general")):
        one = style.where(rows, torque=torque, scheme="consistent")
        a.loglog(one["dt_s"], one["error_rad"], **style.cycle(k), label=torque)
    x = np.array([3e-6, 3e-4])
    for order, y in ((1, 8e-5), (2, 3e-11)):
        a.plot(x, y * (x / x[0]) ** order, color="0.45", linewidth=0.9)
        a.text(x[0] * 6, y * 6 ** order * (6 if order == 1 else 0.1), f"order {order}",
               fontsize=7, color="0.35")
    style.label(a, "time step / s", "error of the orientation / rad", "consistent, torque and spin")
    a.legend(loc="lower right")
    a = ax[0][1]
    for k, torque in enumerate(("parallel", "skew", "general")):
        one = style.where(rows, torque=torque, scheme="paper")
        a.loglog(one["dt_s"], one["error_rad"], **style.cycle(k), label=torque)
    style.label(a, "time step / s", "error of the orientation / rad", "paper, torque and spin")
    a.legend(loc="lower right")
    a = ax[1][0]
    for scheme in ("consistent", "paper"):
        one = style.where(axes, scheme=scheme)
        a.semilogx(one["steps"], one["error_deg"], **style.LINE[scheme], label=scheme)
    style.label(a, "steps per quarter turn", "error of the orientation / deg",
                "two quarter turns, about x, then y")
    a.legend(loc="center")
    a = ax[1][1]
    a.loglog(fast["angle_per_step_rad"], np.maximum(fast["error_rad"], 1e-17), linestyle="none",
             marker="o", markersize=3, color=style.COLORS[0], markerfacecolor="white",
             label="error after 100 steps")
    a.plot(fast["angle_per_step_rad"], 2.2e-16 * np.maximum(1, 100 * fast["angle_per_step_rad"]),
           label="rounding of the angle", **style.LINE["alternative"])
    style.label(a, "angle turned per step / rad", "error of the orientation / rad",
                f"constant spin; norm drifts by {abs(norm['norm_minus_1']).max():.0e}")
    a.legend(loc="upper left")
    style.save(fig, out, "19_spiral")
