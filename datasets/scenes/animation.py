# SPDX-License-Identifier: BSD-3-Clause
"""Many frames by one single-threaded POV-Ray process. It finds each frame's camera and moving things in a small file
that it includes by frame number; its pictures are taken up as they come."""

import subprocess
import time
from pathlib import Path

import cv2

import trajectory as tj
from sequence import TARGET_LIFT_M

HERE = Path(__file__).resolve().parent
DEPTH_UNIT_M = 1 / 5000.0  # of a depth PNG, as TUM has it
POLL_S = 0.05
RUNNING = set()  # the POV-Ray processes, to be ended if we are


class PovrayFailed(RuntimeError):
    pass


def pose_include(sequence, frame):
    pose = sequence.poses[frame]
    R = tj.rotation(pose[4:])
    value = {"Tx": pose[1], "Ty": pose[2], "Tz": pose[3] + TARGET_LIFT_M}
    value.update({a + b: R[j, i] for i, a in enumerate("XYZ") for j, b in enumerate("xyz")})
    lines = [f"#declare {k} = {v:.16g};" for k, v in value.items()]
    boxes = sequence.still + sequence.moving(frame)
    skins = [
        f'#declare Skin_{p} = Picture("{p}")' for p in sorted({p for box in boxes for p in box.pictures})
    ]  # each is read once
    return "\n".join(lines + ["#macro Things()"] + skins + [box.scene_line() for box in boxes] + ["#end"]) + "\n"


def command(sequence, count, depth, pictures, work):
    camera, s = sequence.camera, 1 if depth else sequence.rays_per_side
    width, height = round(camera.width * s), round(camera.height * s)
    declared = {
        "Depth": int(depth),
        "Far": 65535 * DEPTH_UNIT_M,
        "WideX": camera.width / camera.fx,
        "WideY": camera.height / camera.fy,
    }
    return [
        "povray",
        f"+I{HERE / sequence.scene}",
        f"+L{HERE}",
        f"+L{pictures}",
        f"+L{work}",
        f"+O{work / 'out'}",
        f"+W{width}",
        f"+H{height}",
        "+FP16",
        "Grayscale_Output=on",
        "File_Gamma=1.0",
        "-A",
        "-D",
        "-V",
        "-GA",
        "+GF",
        "+BM2",
        "+WT1",
        "+KI0",
        "+KF1",
        "+KFI1",
        f"+KFF{count}",
        "-KC",
    ] + [f"Declare={k}={v:.16g}" for k, v in declared.items()]


def rendered(work, count, i):
    """POV-Ray numbers its files with as many digits as the last one has."""
    return work / f"out{i:0{len(str(count))}d}.ppm"


def read_pgm(path):
    image = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
    if image is None:
        raise PovrayFailed(f"{path}: no picture")
    return image if image.ndim == 2 else image[:, :, 0]


def animate(sequence, frames, depth, pictures, work):
    """Yields (frame, 16-bit linear image) for the given frames, as soon as each is done."""
    work.mkdir(parents=True, exist_ok=True)
    for i, frame in enumerate(frames, 1):
        (work / f"pose{i:06d}.inc").write_text(pose_include(sequence, frame))
    log = work / "povray.log"
    with (
        log.open("w") as sink,
        subprocess.Popen(command(sequence, len(frames), depth, pictures, work), stdout=sink, stderr=sink) as povray,
    ):
        RUNNING.add(povray)
        try:
            for i, frame in enumerate(frames, 1):
                path, next_path = rendered(work, len(frames), i), rendered(work, len(frames), i + 1)
                while povray.poll() is None and not next_path.exists():  # a file is whole when the next one is begun
                    time.sleep(POLL_S)
                if povray.poll() not in (None, 0) and not next_path.exists():
                    raise PovrayFailed(
                        f"{sequence.scene} ({sequence.name}):\n" + log.read_text(errors="replace")[-2500:]
                    )
                yield frame, read_pgm(path)
                path.unlink()
        finally:
            RUNNING.discard(povray)
            povray.terminate()
