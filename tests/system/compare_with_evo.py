# SPDX-License-Identifier: BSD-3-Clause
"""mono-slam-eval against evo (PyPI) on a made-up trajectory: all figures agree to 1e-6.

usage: compare_with_evo.py MONO_SLAM_EVAL [GROUNDTRUTH ESTIMATE]
Exit status 77 (skipped) where evo is not installed; tests/run.sh installs it to build/venv-report.
"""
import copy
import json
import math
import os
import random
import subprocess
import sys
import tempfile

HOME = tempfile.TemporaryDirectory()  # evo writes its settings there as soon as it is imported
os.environ["HOME"] = HOME.name
try:
    from evo.core import metrics, sync
    from evo.core.units import Unit
    from evo.tools import file_interface
except ImportError:
    print("skipped: evo is not installed; pip install -r tests/requirements.txt")
    sys.exit(77)

RELATION = metrics.PoseRelation
TOLERANCE = 1e-6


def quaternion(roll, pitch, yaw):
    cr, sr = math.cos(roll / 2), math.sin(roll / 2)
    cp, sp = math.cos(pitch / 2), math.sin(pitch / 2)
    cy, sy = math.cos(yaw / 2), math.sin(yaw / 2)
    return (sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
            cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy)


def write(name, poses):
    with open(name, "w") as file:
        file.write("# timestamp tx ty tz qx qy qz qw\n")
        for pose in poses:
            file.write(" ".join("%.17g" % number for number in pose) + "\n")


def make(folder):
    """A winding path at 30 Hz, and an estimate of it: other frame, 0.8 of the size, noise, gaps."""
    rng = random.Random(7)
    truth, estimate = [], []
    for i in range(300):
        t = 1305031229.5 + i / 30.0
        a = i / 40.0
        p = (math.sin(a), 0.4 * math.cos(1.7 * a), 0.3 * a)
        truth.append((t, *p, *quaternion(0.2 * math.sin(a), 0.3 * math.cos(a), 0.1 * a)))
        if rng.random() < 0.1:
            continue
        q = quaternion(*[x + rng.gauss(0, 0.01)
                         for x in (0.2 * math.sin(a), 0.3 * math.cos(a), 0.1 * a)])
        noisy = [0.8 * x + rng.gauss(0, 0.005) for x in (p[1], -p[0], p[2])]
        estimate.append((t + rng.uniform(-0.004, 0.004), *noisy, *q))
    write(folder + "/truth.tum", truth)
    write(folder + "/estimate.tum", estimate)
    return folder + "/truth.tum", folder + "/estimate.tum"


def evo_figures(truth_file, estimate_file):
    truth = file_interface.read_tum_trajectory_file(truth_file)
    estimate = file_interface.read_tum_trajectory_file(estimate_file)
    truth, estimate = sync.associate_trajectories(truth, estimate, max_diff=0.02)
    figures = {"frames_matched": estimate.num_poses, "truth_length_m": truth.path_length}
    for name in ("none", "SE3", "Sim3"):
        aligned = copy.deepcopy(estimate)
        if name != "none":
            _, _, scale = aligned.align(truth, correct_scale=name == "Sim3")
            figures["scale"] = scale
        add(figures, name + "_ate_%s_mm", 1e3, metrics.APE(RELATION.translation_part),
            truth, aligned, ("rmse", "mean", "median", "max"))
        add(figures, name + "_rot_%s_deg", 1, metrics.APE(RELATION.rotation_angle_deg),
            truth, aligned, ("rmse", "max"))
        add(figures, name + "_rpe_frame_%s_mm", 1e3,
            metrics.RPE(RELATION.translation_part, 1, Unit.frames), truth, aligned, ("rmse",))
    add(figures, "rpe_frame_rot_%s_deg", 1,
        metrics.RPE(RELATION.rotation_angle_deg, 1, Unit.frames), truth, estimate, ("rmse",))
    return {key.replace("rot_rmse", "rot_rms"): value for key, value in figures.items()}


def add(figures, key, unit, metric, truth, estimate, names):
    metric.process_data((truth, estimate))
    statistics = metric.get_all_statistics()
    for name in names:
        figures[key % name] = unit * statistics[name]


def main():
    with tempfile.TemporaryDirectory() as folder:
        truth, estimate = sys.argv[2:4] if len(sys.argv) > 3 else make(folder)
        output = os.path.join(folder, "figures.json")
        subprocess.run([sys.argv[1], "--groundtruth", truth, estimate, "--nearest", "--json",
                        output], check=True, stdout=subprocess.DEVNULL)
        with open(output) as file:
            ours = json.load(file)[0]
        worst = 0.0
        for key, value in evo_figures(truth, estimate).items():
            difference = abs(ours[key] - value) / max(1.0, abs(value))
            worst = max(worst, difference)
            print("%-24s %18.9f %18.9f %9.1e" % (key, ours[key], value, difference))
        print("largest difference: %.1e" % worst)
        return 0 if worst <= TOLERANCE else 1


if __name__ == "__main__":
    sys.exit(main())
