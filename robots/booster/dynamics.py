"""Rigid-body dynamics for the stand-in: the robot's model of this repository in MuJoCo, with the firmware's standing posture."""

import math
import os

import mujoco
import numpy as np

LEGS = {"t1": (-27.669, 0, 0, 47.965, -20.296, 0), "k1": (-22.596, 0, 0, 46.388, -23.792, 0)}
ARM = (0, -83, 0, -5.73)
TORQUE = {"t1": [7, 7] + [18] * 8 + [30] + [45, 30, 30, 60, 20, 15] * 2, "k1": [6, 6] + [14] * 8 + [30, 35, 20, 40, 20, 20] * 2}
# That of `bica-body`, which a test compares: on another floor the arms push otherwise.
FLOOR = '<geom name="Floor" type="plane" size="0 0 1" group="3" contype="4" conaffinity="3" friction="0.9 0.005 0.0001"/>'
BALL = ('<body name="Ball"><freejoint name="Ball"/><geom type="sphere" size="0.0325" mass="0.055" contype="16" conaffinity="45" condim="6" '
        'priority="2" friction="0.7 0.003 0.0016" solref="0.01 0.25"/></body>')  # that of the NAO's field
SIDES = {"front": 0, "left": 1, "back": 2, "right": 3}
STEP = 0.002


class Dynamics:
    def __init__(self, robot):
        folder = os.path.join(os.path.dirname(__file__), "../../bica-motion/models", robot)
        with open(os.path.join(folder, "robot.xml"), encoding="utf-8") as file:
            self.model = mujoco.MjModel.from_xml_string(file.read().replace("<worldbody>", "<worldbody>" + FLOOR, 1)
                                                         .replace("</worldbody>", BALL + "</worldbody>", 1))
        self.data = mujoco.MjData(self.model)
        self.model.opt.timestep = STEP
        count = self.model.nu
        waist = (0,) if count == 23 else ()
        right = (0, 83, 0, 5.73)
        self.stand = np.radians([0, 0, *ARM, *right, *waist, *LEGS[robot], *LEGS[robot]])
        self.torque = np.array(TORQUE[robot])
        self.held = np.where(np.arange(count) > 9, 400.0, 40.0)
        # The robot's motors damp: what is commanded replaces the damping of the model.
        self.damping = self.model.dof_damping[6:6 + count].copy()
        self.joints, self.speeds = self.data.qpos[7:7 + count], self.data.qvel[6:6 + count]
        self.joints[:] = self.stand
        self.ball = self.data.joint("Ball")
        self.place_ball(-3.0, 0.0)
        self.data.qpos[2] = 1.0
        mujoco.mj_forward(self.model, self.data)
        soles = [self.data.geom(name).xpos[2] - self.model.geom(name).size[2] for name in ("LSole", "RSole")]
        self.data.qpos[2] -= min(soles) - 0.001

    def advance(self, steps, motors, is_held):
        """Some steps with the commanded gains, or with those of the firmware, which holds the stand or damps."""
        if motors is not None:
            kp, kd, target, torque = np.array([(motor.kp, motor.kd, motor.q, motor.tau) for motor in motors]).T
        else:
            kp, kd, target, torque = self.held * is_held, self.damping, self.stand, 0.0
        self.model.dof_damping[6:6 + len(kd)] = kd
        for _ in range(steps):
            damped = kd * self.speeds
            self.data.ctrl[:] = np.clip(kp * (target - self.joints) + torque - damped, -self.torque, self.torque) + damped
            mujoco.mj_step(self.model, self.data)

    def angles(self):
        return self.joints.tolist(), self.speeds.tolist()

    def inertial(self):
        """Roll, pitch and yaw, angular velocity, specific force."""
        w, x, y, z = self.data.qpos[3:7]
        roll = math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
        pitch = math.asin(max(-1.0, min(1.0, 2 * (w * y - z * x))))
        yaw = math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
        sensors = [float(value) for value in self.data.sensordata]
        return [roll, pitch, yaw], sensors[:3], sensors[3:6]

    def push(self, speed=2.5, side="front"):
        """A velocity, m/s, to a side of the robot: no step stops 2.0 m/s."""
        yaw = self.inertial()[0][2] + SIDES[side] * math.pi / 2
        self.data.qvel[:2] += [speed * math.cos(yaw), speed * math.sin(yaw)]

    def place_ball(self, x, y):
        self.ball.qpos[:] = [x, y, 0.0325, 1, 0, 0, 0]
        self.ball.qvel[:] = 0

    def ground(self):
        """Position between the ankles, m, and heading, rad."""
        x, y, _ = sum(self.data.xpos[self.model.geom(name).bodyid[0]] for name in ("LSole", "RSole")) / 2
        return x, y, self.inertial()[0][2]

    def pose(self):
        """Position along x and y, height of the hips, m, and yaw, rad."""
        return *map(float, self.data.qpos[:3]), self.inertial()[0][2]
