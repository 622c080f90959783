"""Compares this crate's messages with the maker's wheel: `pip install booster_robotics_sdk_python==1.6.3` (Linux, CPython 3.11).

    cargo build -p bica-booster --example as_robot --features dds
    python3 robots/booster/check_wheel.py target/debug/examples/as_robot
"""

import subprocess
import sys
import threading
import time

import booster_robotics_sdk_python as booster

got = {}
robot = subprocess.Popen([sys.argv[1], "0", "14"], stdout=subprocess.PIPE, text=True)
lines = []
threading.Thread(target=lambda: lines.extend(robot.stdout), daemon=True).start()
booster.ChannelFactory.Instance().Init(0, "127.0.0.1")
subscribers = [booster.B1LowStateSubscriber(lambda it: got.setdefault("state", (
                   list(it.imu_state.rpy), list(it.imu_state.gyro), list(it.imu_state.acc),
                   [[(m.mode, round(m.q, 4), m.dq, m.ddq, m.tau_est, m.temperature, m.lost) for m in motors]
                    for motors in (it.motor_state_serial, it.motor_state_parallel)]))),
               booster.B1OdometerStateSubscriber(lambda it: got.setdefault("odometer", (it.x, it.y, it.theta))),
               booster.B1FallDownStateSubscriber(lambda it: got.setdefault("fall", (
                   int(it.fall_down_state), it.is_recovery_available)))]
for subscriber in subscribers:
    subscriber.InitChannel()
publisher, client = booster.B1LowCmdPublisher(), booster.B1LocoClient()
publisher.InitChannel()
client.Init()
command = booster.LowCmd()
command.cmd_type = booster.LowCmdType.SERIAL
motors = []
for index in range(23):
    motor = booster.MotorCmd()
    motor.q, motor.dq, motor.tau, motor.kp, motor.kd, motor.weight = 0.5, 1.5, 2.5, 3.5 + index, 4.5, 0.75
    motors.append(motor)
command.motor_cmd = motors
end = time.monotonic() + 12
mode = None
while time.monotonic() < end and not (len(got) == 3 and mode and any(line.startswith("command") for line in lines)):
    publisher.Write(command)
    time.sleep(0.2)
    if "state" in got:
        mode = client.GetMode().mode
robot.wait(20)
expected = [[(i, round(0.01 * i, 4), 1.0 + i, 100.0 + i, -float(i), 40 + i, 1000 + i) for i in range(first, first + 23)]
            for first in (0, 100)]
rpy, gyro, acc, lists = got["state"]
assert [round(value, 4) for value in rpy] == [0.1, 0.2, 0.3] and gyro == [1, 2, 3] and acc == [0.5, 0.25, 9.75], got["state"][:3]
assert lists == expected, lists
assert got["odometer"] == (1.5, -2.5, 0.75) and got["fall"] == (2, True), got
sent = "MotorCmd { mode: 0, q: 0.5, dq: 1.5, tau: 2.5, kp: 25.5, kd: 4.5, weight: 0.75 }"
assert any(line.startswith(f"command 1 23 Some({sent})") for line in lines), lines[:3]
assert mode == booster.RobotMode.kCustom, mode
print("state, odometer, fall, command, request and answer agree;", next(line for line in lines if "2017" in line).strip())
