"""Trials of a program behind a Booster's topics in MuJoCo, in real time: walks, kicks, and getting up. It prints the median of the seeds
beside the figures of docs/performance.md, by `player trial`, and ends with exit code 1 if one differs by more than 20 %.

    python3 robots/booster/trial.py t1|k1 PLAYER [--seeds 3] [--domain 0] [--only walk,kick,rise]

PLAYER is the program; it is driven over its link. A seed moves the ball by 1 cm at most along each axis, and sets the speed of pushes.
"""

import argparse
import math
import random
import statistics
import subprocess
import sys

from stand_in import Robot, run

ADDRESS = "127.0.0.1:7455"
AXES = ["ahead", "left", "turn"]
# Velocity ahead and to the left, m/s, and turn, rad/s; then the mean along the axis of the largest one.
WALKS = {"t1": [((0.4, 0, 0), 0.40), ((-0.2, 0, 0), -0.20), ((0, 0.2, 0), 0.20), ((0, 0, 0.7), 0.68)],
         "k1": [((0.3, 0, 0), 0.31), ((-0.15, 0, 0), -0.14), ((0, 0.15, 0), 0.12), ((0, 0, 0.6), 0.60)]}
# Place of the ball before the left foot, m, and its way; 4.3 m end in the net of a goal, which is not here.
KICKS = {"t1": {"front": (0.217, 0.121, 4.3), "diagonal": (0.245, 0.125, 4.3), "lateral": (0.185, 0.07, 2.8)},
         "k1": {"front": (0.184, 0.097, 4.3), "diagonal": (0.2, 0.03, 2.9), "lateral": (0.163, 0.05, 1.6)}}
# s; of the sides `player trial` has no figure, so that they are only printed.
RISES = {"t1": {"front": 3.7, "left": math.inf, "back": 3.0, "right": math.inf},
         "k1": {"front": 3.8, "left": math.inf, "back": 3.1, "right": math.inf}}
NET = 4.3


class Trial:
    def __init__(self, robot, name, player, numbers, only):
        self.robot, self.name, self.player, self.numbers, self.only = robot, name, player, numbers, only
        self.results, self.falls, self.is_down, self.height = {}, 0, False, 0.0

    def drive(self, seconds, held, *call):
        """Drives the robot by one call of a modulation, and waits."""
        command = [self.player, "link", ADDRESS, "modulate", *map(str, call), "--seconds", str(seconds)]
        holds = [f"--hold={hold}" for hold in ("Player=latent", f"{held}=active")]
        process = subprocess.Popen([*command, *holds], stdout=subprocess.DEVNULL)
        yield from self.wait(seconds + 0.5)
        if process.wait(timeout=20) != 0:
            self.robot.violation(f"the link refuses {call}")

    def wait(self, seconds):
        end = self.robot.now + seconds
        while self.robot.now < end:
            self.is_down |= self.robot.dynamics.pose()[2] < 0.6 * self.height
            yield

    def walk(self, velocity, expected):
        axis = max(range(3), key=lambda axis: abs(velocity[axis]))
        turned, track, start = 0.0, [], self.robot.now
        for _ in self.drive(7.0, "Body", "Body.walk", *velocity):
            yield
            if 2.0 <= self.robot.now - start <= 6.5:
                x, y, _, yaw = self.robot.dynamics.pose()
                turned += math.remainder(yaw - track[-1][3], math.tau) if track else 0.0
                track.append((self.robot.now, x, y, yaw))
        (t, x, y, yaw), (last, *end, _) = track[0], track[-1]
        way = (end[0] - x, end[1] - y)
        moved = (way[0] * math.cos(yaw) + way[1] * math.sin(yaw), way[1] * math.cos(yaw) - way[0] * math.sin(yaw), turned)
        self.note(f"walk {AXES[axis]} {velocity[axis]}", moved[axis] / (last - t), expected)
        yield from self.wait(1.5)

    def kick(self, kind, foot):
        ahead, aside, expected = KICKS[self.name][kind]
        side = 1 if foot == "left" else -1
        # As the steps that line up with a ball do: a kick leaves the feet elsewhere than the stand has them, and another one would fall.
        yield from self.drive(1.5, "Body", "Body.walk", 0.1, 0, 0)
        yield from self.wait(1.5)
        error = lambda: self.numbers.uniform(-0.01, 0.01)
        x, y, yaw = self.robot.dynamics.ground()
        ahead, aside = ahead + error(), side * aside + error()
        start = x + ahead * math.cos(yaw) - aside * math.sin(yaw), y + ahead * math.sin(yaw) + aside * math.cos(yaw)
        self.robot.dynamics.place_ball(*start)
        yield from self.drive(5.0, "Kicker", "Kicker.kick", kind.capitalize(), foot.capitalize())
        yield from self.wait(5.0)
        ball = self.robot.dynamics.ball.qpos
        self.note(f"kick {kind} {foot}", min(NET, math.dist(start, ball[:2])), expected)

    def rise(self, side, expected):
        self.robot.dynamics.place_ball(-9.0, 0.0)
        self.robot.dynamics.push(self.numbers.uniform(2.0, 2.6), side)
        lies, stands = None, None
        for _ in self.wait(15.0):
            yield
            low = self.robot.dynamics.pose()[2] < 0.5 * self.height
            lies = self.robot.now if low and lies is None else lies
            is_up = self.robot.dynamics.pose()[2] > 0.9 * self.height
            stands = (stands or self.robot.now) if lies and is_up else None
            if stands and self.robot.now > stands + 3.0:
                break
        self.note(f"getting up, {side}, s", stands - lies if lies and stands else math.inf, expected)

    def note(self, what, result, expected):
        self.results[what] = (result, expected)
        self.falls += self.is_down and "getting" not in what
        print(f"{self.robot.now:.1f} s: {what}: {result:.2f}{', falls' * (self.is_down and 'getting' not in what)}", flush=True)
        self.is_down = False

    def steps(self):
        while self.robot.entered is None:
            yield
        yield from self.wait(6.0)
        self.height = self.robot.dynamics.pose()[2]
        if "walk" in self.only:
            for velocity, expected in WALKS[self.name]:
                yield from self.walk(velocity, expected)
        if "kick" in self.only:
            for kind in KICKS[self.name]:
                for foot in ("left", "right"):
                    yield from self.kick(kind, foot)
        if "rise" in self.only:
            for side, expected in RISES[self.name].items():
                yield from self.rise(side, expected)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("robot", choices=["t1", "k1"])
    parser.add_argument("player")
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--domain", type=int, default=0)
    parser.add_argument("--only", default="walk,kick,rise")
    options = parser.parse_args()
    all_results, violations, falls, lost = {}, 0, 0, 0
    for seed in range(options.seeds):
        robot = Robot(options.robot, options.domain, [], True)
        play = ["play", "--world", "booster", "--robot", options.robot, "--dds-domain", str(options.domain)]
        command = [options.player, *play, "--dds-interface", "127.0.0.1", "--serve", ADDRESS]
        trial = Trial(robot, options.robot, options.player, random.Random(seed), options.only.split(","))
        violations += not run(robot, math.inf, command, trial.steps())
        violations, falls = violations + len(robot.violations), falls + trial.falls
        lost += robot.counts.get("steps lost", 0)
        for what, (result, expected) in trial.results.items():
            all_results.setdefault((what, expected), []).append(result)
    wrong = falls + violations
    for (what, expected), results in all_results.items():
        median = statistics.median(results)
        # A ball may roll farther, and a robot rise sooner.
        share = median / expected
        is_good = share <= 1.2 if "getting" in what else share >= 0.8 and (share <= 1.2 or "kick" in what)
        wrong += not is_good
        print(f"{what}: median {median:.2f} of {len(results)}, {min(results):.2f} to {max(results):.2f}; docs {expected:.2f}"
              + ("" if is_good else "  DIFFERS"))
    print(f"{violations} violations, {falls} falls, {lost} steps of 2 ms without time for them")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
