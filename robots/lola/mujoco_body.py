"""The body of the stand-in in MuJoCo: a NAO on a field of 2009, which attacks the goal at positive x. It is a referee, too.

The robot is held in its stand until all its legs have a stiffness of 0.3. Commands reach the motors two maps later.
"""

import math
import os
import random
from collections import deque
from pathlib import Path

os.environ.setdefault("MUJOCO_GL", "egl")  # before the import: a computer without a screen

import mujoco
import numpy as np

JOINTS = ["HeadYaw", "HeadPitch", "LShoulderPitch", "LShoulderRoll", "LElbowYaw", "LElbowRoll", "LWristYaw", "LHipYawPitch", "LHipRoll",
          "LHipPitch", "LKneePitch", "LAnklePitch", "LAnkleRoll", "RHipRoll", "RHipPitch", "RKneePitch", "RAnklePitch", "RAnkleRoll",
          "RShoulderPitch", "RShoulderRoll", "RElbowYaw", "RElbowRoll", "RWristYaw", "LHand", "RHand"]
LEGS = range(7, 18)
STAND = {"ShoulderPitch": 1.57, "HipPitch": -0.429685, "KneePitch": 0.846493, "AnklePitch": -0.416808}
SIDES = {"ShoulderRoll": 0.15, "ElbowYaw": -1.2, "ElbowRoll": -0.4}  # of the left side; the right one mirrors it
HIPS = 0.2302  # m, over the soles
SERVOS = [("Hip", 40, 5), ("Knee", 40, 5), ("Ankle", 40, 5), ("Wrist", 2, 0.6), ("Hand", 0.5, 0.3), ("", 15, 2.5)]  # Nm/rad, Nm
FEET = [f"{side}{place}" for side in "LR" for place in ("FrontLeft", "FrontRight", "RearLeft", "RearRight")]
FIELD_OF_VIEW = 43.7  # degrees, vertical: the maker's value for a V6
AMPERES = 0.4  # per Nm
YUV = np.array([[0.299, 0.587, 0.114], [-0.168736, -0.331264, 0.5], [0.5, -0.418688, -0.081312]])  # BT.601, full range
ROBOT = Path(__file__).resolve().parents[2] / "bica-motion/models/nao/robot.xml"


def field():
    """MJCF of the project's robot on a field of 2009: 6.0 x 4.0 m, goals 1.4 x 0.8 m, ball 65 mm and 55 g."""
    lines = [(0, 2, 3.025, 0.025, 0), (0, -2, 3.025, 0.025, 0), (0, 0, 0.025, 2.025, 0)]
    for x in (1, -1):
        lines += [(3 * x, 0, 0.025, 2.025, 0), (2.4 * x, 0, 0.025, 1.125, 0), (2.7 * x, 1.1, 0.325, 0.025, 0),
                  (2.7 * x, -1.1, 0.325, 0.025, 0), (1.2 * x, 0, 0.05, 0.025, 0), (1.2 * x, 0, 0.025, 0.05, 0)]
    for angle in np.arange(48) * math.tau / 48:
        lines.append((0.6 * math.cos(angle), 0.6 * math.sin(angle), 0.025, 0.0414, angle))
    looks = 'contype="0" conaffinity="0"'
    geoms = [f'<geom type="box" pos="{x} {y} 0" size="{w} {h} 0.001" euler="0 0 {a}" rgba="0.95 0.95 0.95 1" {looks}/>'
             for x, y, w, h, a in lines]
    for x, colour in ((3, "0.95 0.82 0.05 1"), (-3, "0.1 0.35 0.9 1")):
        solid = f'rgba="{colour}" contype="8" conaffinity="33"'
        net = 'rgba="0.8 0.8 0.8 0.25" contype="8" conaffinity="33" solref="0.02 2"'
        back = x * 1.133
        geoms += [f'<geom type="cylinder" size="0.05" fromto="{x} {y} 0 {x} {y} 0.8" {solid}/>' for y in (0.7, -0.7)]
        geoms += [f'<geom type="box" pos="{(x + back) / 2} {y} 0.15" size="0.18 0.004 0.15" {net}/>' for y in (0.7, -0.7)]
        geoms += [f'<geom type="cylinder" size="0.025" fromto="{x} -0.7 0.775 {x} 0.7 0.775" {solid}/>',
                  f'<geom type="box" pos="{back} 0 0.15" size="0.004 0.7 0.15" {net}/>']
    return f"""<mujoco model="field"><include file="{ROBOT}"/>
        <visual><global offwidth="640" offheight="480"/><quality offsamples="0"/><map znear="0.01" zfar="30"/>
        <headlight ambient="0.35 0.35 0.35" diffuse="0.25 0.25 0.25" specular="0 0 0"/></visual>
        <statistic center="0 0 0.3" extent="2"/>
        <asset><texture type="skybox" builtin="flat" rgb1="0.55 0.55 0.57" width="64" height="384"/></asset>
        <worldbody><light directional="true" pos="0 0 4" dir="0.2 0.1 -1" diffuse="0.7 0.7 0.7" castshadow="false"/>
        <geom type="plane" size="0 0 1" contype="4" conaffinity="19" rgba="0 0 0 0" friction="0.9 0.005 0.0001" group="3"/>
        <geom type="plane" size="9 8 1" pos="0 0 -0.01" rgba="0.45 0.43 0.42 1" {looks}/>
        <geom type="plane" size="3.7 2.7 1" rgba="0.07 0.42 0.16 1" {looks}/>{"".join(geoms)}
        <body name="ball"><freejoint name="ball"/><geom type="sphere" size="0.0325" mass="0.055" rgba="0.95 0.35 0.03 1" contype="16"
        conaffinity="45" condim="6" priority="2" friction="0.7 0.003 0.0016" solref="0.01 0.25"/></body></worldbody></mujoco>"""


class Body:
    def __init__(self, model, seed, size):
        self.model = mujoco.MjModel.from_xml_path(model) if model else mujoco.MjModel.from_xml_string(field())
        self.data, self.random = mujoco.MjData(self.model), random.Random(seed)
        self.width, self.height = size
        self.joints = [self.model.joint(name).qposadr[0] for name in JOINTS]
        self.motors = [self.find("actuator", name, name.removeprefix("L")) for name in JOINTS]
        self.feet = [self.address(name[0] + "FSR" + name[1:], name) for name in FEET]
        self.gyro, self.accelerometer = self.address("gyroscope", "Gyro"), self.address("accelerometer", "Accelerometer")
        self.ball = self.model.joint("ball").qposadr[0]
        self.cameras = [self.find("camera", name, name.capitalize()) for name in ("top", "bottom")]
        for camera in self.cameras:
            self.model.cam_fovy[camera] = FIELD_OF_VIEW
        self.gains = [self.servo(motor, name) for motor, name in zip(self.motors, JOINTS)]
        self.renderer = mujoco.Renderer(self.model, self.height, self.width)
        self.end, self.seconds, self.falls, self.outs = None, 0.0, 0, 0
        self.draw()
        self.reset()

    def find(self, kind, *names):
        """The number of the first thing of this kind that the model has."""
        identify = lambda name: mujoco.mj_name2id(self.model, getattr(mujoco.mjtObj, "mjOBJ_" + kind.upper()), name)
        found = [identify(name) for name in names if identify(name) >= 0]
        if not found:
            raise SystemExit(f"error: the model has no {kind} {' or '.join(names)}; give another --model")
        return found[0]

    def address(self, *names):
        return self.model.sensor_adr[self.find("sensor", *names)]

    def servo(self, motor, name):
        """Makes a position servo of a motor; returns its gain."""
        if self.model.actuator_biastype[motor] == mujoco.mjtBias.mjBIAS_NONE:
            _, gain, torque = next(servo for servo in SERVOS if servo[0] in name)
            self.model.actuator_biastype[motor] = mujoco.mjtBias.mjBIAS_AFFINE
            self.model.actuator_gainprm[motor, 0] = gain
            self.model.actuator_forcelimited[motor], self.model.actuator_forcerange[motor] = 1, (-torque, torque)
        return self.model.actuator_gainprm[motor, 0]

    def draw(self):
        """Draws where ball and robot start."""
        draw = self.random.uniform
        self.start, way, angle = (draw(0.3, 1.6), draw(-1, 1)), draw(0.8, 2.2), draw(-math.pi, math.pi)
        self.place = (max(-2.5, min(2.5, self.start[0] + way * math.cos(angle))),
                      max(-1.6, min(1.6, self.start[1] + way * math.sin(angle))), draw(-math.pi, math.pi))
        self.place_ball()

    def place_ball(self):
        self.data.qpos[self.ball:self.ball + 7] = [*self.start, 0.0325, 1, 0, 0, 0]
        self.data.joint("ball").qvel[:] = 0

    def reset(self):
        """Holds the robot in its stand."""
        self.is_held, self.is_down, self.waiting = True, False, deque()
        self.hold()

    def hold(self):
        x, y, heading = self.place
        height = self.model.key_qpos[0][2] if self.model.nkey else HIPS
        self.data.qpos[:7] = [x, y, height, math.cos(heading / 2), 0, 0, math.sin(heading / 2)]
        self.data.qvel[:self.model.joint("ball").dofadr[0]] = 0
        for adr in self.model.jnt_qposadr[1:]:
            name = self.model.joint(int(np.flatnonzero(self.model.jnt_qposadr == adr)[0])).name
            side = -1 if name.startswith("R") else 1
            if name != "ball":
                self.data.qpos[adr] = STAND.get(name[1:], side * SIDES.get(name[1:], 0))
        mujoco.mj_forward(self.model, self.data)

    @property
    def q(self):
        return [float(self.data.qpos[joint]) for joint in self.joints]

    def step(self, targets, stiffness):
        """Advances by one map."""
        self.seconds += 0.012
        self.waiting.append((targets, stiffness))
        if self.is_held and all(stiffness[j] >= 0.3 for j in LEGS):
            self.is_held = False
        if len(self.waiting) > 2:
            for motor, gain, target, stiff in zip(self.motors, self.gains, *self.waiting.popleft()):
                self.data.ctrl[motor] = target
                self.model.actuator_gainprm[motor, 0] = gain * max(0.0, stiff)
                self.model.actuator_biasprm[motor, 1] = -gain * max(0.0, stiff)
        mujoco.mj_step(self.model, self.data, nstep=6)
        if self.is_held:
            self.hold()
        self.judge()

    def judge(self):
        x, y, _ = self.data.qpos[self.ball:self.ball + 3]
        is_down = 2 * (self.data.qpos[4] ** 2 + self.data.qpos[5] ** 2) > 0.5
        self.falls += is_down and not self.is_down
        self.is_down = is_down
        if abs(x) > 3.06 and abs(y) < 0.65:
            self.end = self.end or ("goal" if x > 0 else "own goal")
        elif abs(x) > 3.1 or abs(y) > 2.1:
            self.outs += 1
            self.place_ball()

    def push(self):
        self.data.qvel[self.random.randrange(2)] += 0.4

    def values(self):
        """What differs from a robot at rest, in LoLA's units."""
        noise = self.random.gauss
        read = lambda adr, spread: [float(value) + noise(0, spread) for value in self.data.sensordata[adr:adr + 3]]
        w, x, y, z = self.data.qpos[3:7]
        roll, pitch = math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)), math.asin(max(-1, min(1, 2 * (w * y - z * x))))
        return {"Accelerometer": [-value for value in read(self.accelerometer, 0.05)], "Gyroscope": read(self.gyro, 5e-3),
                "Angles": [roll + noise(0, 2e-3), pitch + noise(0, 2e-3)],
                "Current": [AMPERES * abs(float(self.data.actuator_force[motor])) for motor in self.motors],
                "FSR": [max(0.0, float(self.data.sensordata[adr]) / 9.81 + noise(0, 0.01)) for adr in self.feet]}

    def image(self, camera, number):
        """Pixels in YUYV."""
        self.renderer.update_scene(self.data, camera=self.cameras[camera])
        rgb = self.renderer.render().astype(np.float32) + np.random.default_rng(number).normal(0, 2, (self.height, self.width, 1))
        yuv = rgb @ YUV.T.astype(np.float32)
        colours = yuv[:, 0::2, 1:] / 2 + yuv[:, 1::2, 1:] / 2 + 128
        pixels = np.empty((self.height, self.width, 2), np.float32)
        pixels[:, :, 0] = yuv[:, :, 0]
        pixels[:, 0::2, 1], pixels[:, 1::2, 1] = colours[:, :, 0], colours[:, :, 1]
        return pixels.clip(0, 255).astype(np.uint8).tobytes()

    def report(self):
        return f"{self.end or 'no goal'} after {self.seconds:.1f} s, {self.falls} falls, the ball was out {self.outs} times"
