"""Rigid-body dynamics for the stand-in: the robot's model of this repository in MuJoCo, with the firmware's standing posture."""

import math
import os

import mujoco

LEGS = {"t1": (-27.669, 0, 0, 47.965, -20.296, 0), "k1": (-22.596, 0, 0, 46.388, -23.792, 0)}
ARM = (0, -83, 0, -5.73)
TORQUE = {"t1": [7, 7] + [18] * 8 + [30] + [45, 30, 30, 60, 20, 15] * 2, "k1": None}
FLOOR = '<geom name="floor" type="plane" size="0 0 1" contype="4" conaffinity="3" condim="3" friction="1 0.01 0.0005"/>'
STEP = 0.002


class Dynamics:
    def __init__(self, robot, torque):
        folder = os.path.join(os.path.dirname(__file__), "../../bica-motion/models", robot)
        with open(os.path.join(folder, "robot.xml"), encoding="utf-8") as file:
            self.model = mujoco.MjModel.from_xml_string(file.read().replace("<worldbody>", "<worldbody>" + FLOOR, 1))
        self.data = mujoco.MjData(self.model)
        self.model.opt.timestep = STEP
        count = self.model.nu
        waist = (0,) if count == 23 else ()
        right = (0, 83, 0, 5.73)
        self.stand = [math.radians(angle) for angle in (0, 0, *ARM, *right, *waist, *LEGS[robot], *LEGS[robot])]
        self.torque = TORQUE[robot] or [torque] * count
        # The robot's motors damp: what is commanded replaces the damping of the model.
        self.damping = [float(value) for value in self.model.dof_damping[6:]]
        self.data.qpos[7:] = self.stand
        self.data.qpos[2] = 1.0
        mujoco.mj_forward(self.model, self.data)
        soles = [self.data.geom(name).xpos[2] - self.model.geom(name).size[2] for name in ("LSole", "RSole")]
        self.data.qpos[2] -= min(soles) - 0.001

    def advance(self, steps, motors, is_held):
        """Some steps with the commanded gains, or with those of the firmware, which holds the stand or damps."""
        for _ in range(steps):
            q, dq = self.data.qpos[7:], self.data.qvel[6:]
            for index in range(self.model.nu):
                if motors is not None:
                    motor = motors[index]
                    torque = motor.kp * (motor.q - q[index]) + motor.tau
                    damping = motor.kd
                else:
                    torque = (400.0 if index > 9 else 40.0) * (self.stand[index] - q[index]) if is_held else 0.0
                    damping = self.damping[index]
                limit = self.torque[index]
                self.data.ctrl[index] = min(max(torque - damping * dq[index], -limit), limit) + damping * dq[index]
                self.model.dof_damping[6 + index] = damping
            mujoco.mj_step(self.model, self.data)

    def angles(self):
        return [float(angle) for angle in self.data.qpos[7:]], [float(speed) for speed in self.data.qvel[6:]]

    def inertial(self):
        """Roll, pitch and yaw, angular velocity, specific force."""
        w, x, y, z = self.data.qpos[3:7]
        roll = math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
        pitch = math.asin(max(-1.0, min(1.0, 2 * (w * y - z * x))))
        yaw = math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
        sensors = [float(value) for value in self.data.sensordata]
        return [roll, pitch, yaw], sensors[:3], sensors[3:6]

    def push(self):
        """A velocity of 2.5 m/s ahead, which no step stops."""
        self.data.qvel[0] += 2.5

    def pose(self):
        """Position along x and y, height of the hips, m, and yaw, rad."""
        return *map(float, self.data.qpos[:3]), self.inertial()[0][2]
