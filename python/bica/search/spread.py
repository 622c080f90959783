"""Distribution of blocks of games: threads of this computer, a Ray cluster, or Slurm."""

from __future__ import annotations

import os
import subprocess
import time
from concurrent import futures
from typing import Any

from bica.errors import BicaError
from bica.program import ProgramError, stopping
from bica.search.game import Game, Task, play_block

#: A block that has ended: its games, or why it was lost and has to be played again.
Ended = tuple[Task, list[Game] | str]


class Threads:
    """Threads of this process, each with one program at a time."""

    def __init__(self, workers: int | None) -> None:
        """Take a number of threads, by default one for each core."""
        self.slots = workers or os.cpu_count() or 1
        self._pool = futures.ThreadPoolExecutor(self.slots)
        self._tasks: dict[futures.Future[list[Game]], Task] = {}

    def submit(self, task: Task) -> None:
        """Queue a block."""
        self._tasks[self._pool.submit(play_block, task)] = task

    def next(self) -> Ended:
        """Wait for a block."""
        done, _ = futures.wait(self._tasks, return_when=futures.FIRST_COMPLETED)
        future = done.pop()
        return self._tasks.pop(future), future.result()

    def close(self) -> None:
        """End all blocks at once."""
        for future in self._tasks:
            future.cancel()
        with stopping():
            self._pool.shutdown(cancel_futures=True)


class Ray:
    """Tasks of a Ray cluster. Blocks are repeated by the caller, so that every repetition is known."""

    def __init__(self, address: str, workers: int | None) -> None:
        """Connect to the cluster at `address`; `local` starts one on this computer, for this process."""
        os.environ.setdefault("RAY_ACCEL_ENV_VAR_OVERRIDE_ON_ZERO", "0")
        import ray

        self._ray = ray
        # Only this computer may reach the dashboard, and none is needed.
        options: dict[str, Any] = {"num_cpus": workers, "include_dashboard": False} if address == "local" else {}
        ray.init(address=address, log_to_driver=False, logging_level="ERROR", **options)
        self._play = ray.remote(num_cpus=1, max_retries=0)(play_block)
        self._cores = workers
        self._tasks: dict[Any, Task] = {}

    @property
    def slots(self) -> int:
        """Number of cores of the nodes that are alive."""
        return self._cores or int(self._ray.cluster_resources().get("CPU", 1)) or 1

    def submit(self, task: Task) -> None:
        """Queue a block."""
        self._tasks[self._play.remote(task)] = task

    def next(self) -> Ended:
        """Wait for a block."""
        done, _ = self._ray.wait(list(self._tasks), num_returns=1)
        task = self._tasks.pop(done[0])
        try:
            return task, self._ray.get(done[0])
        except self._ray.exceptions.RayTaskError as error:
            raise error.cause from None
        except self._ray.exceptions.RayError as error:
            return task, f"{type(error).__name__}: {str(error).strip().splitlines()[0]}"

    def close(self) -> None:
        """End all blocks at once: a worker that is killed takes its program with it."""
        for reference in self._tasks:
            self._ray.cancel(reference, force=True)
        self._ray.shutdown()


class Slurm:
    """Jobs of Slurm, one for each block; `slurm:local` runs them as processes of this computer."""

    POLL_S = 0.2

    def __init__(self, local: bool, workers: int | None) -> None:
        """Keep at most `workers` jobs in the queue of Slurm, by default 64, or one for each core of this computer."""
        import submitit

        if not local and subprocess.run(["sacct"], check=False, stdout=subprocess.DEVNULL).returncode != 0:  # noqa: S607
            raise BicaError("`sacct` fails\n  help: a search needs Slurm's accounting, to learn of jobs that were killed")
        self.slots = workers or ((os.cpu_count() or 1) if local else 64)
        self._executor = submitit.AutoExecutor(folder="slurm-jobs", cluster="local" if local else "slurm")
        self._executor.update_parameters(name="bica", timeout_min=60, cpus_per_task=1)
        self._tasks: dict[Any, Task] = {}

    def submit(self, task: Task) -> None:
        """Queue a block."""
        self._tasks[self._executor.submit(play_block, task)] = task

    def next(self) -> Ended:
        """Wait for a block."""
        while not (done := [job for job in self._tasks if job.done()]):
            time.sleep(self.POLL_S)
        task = self._tasks.pop(done[0])
        error = done[0].exception()
        if error is None:
            return task, done[0].result()
        if "ProgramError" in str(error):
            raise ProgramError(str(error).strip().splitlines()[-1])
        return task, f"job {done[0].job_id} ended as {done[0].state}: {str(error).strip().splitlines()[-1]}"

    def close(self) -> None:
        """End all jobs."""
        for job in self._tasks:
            job.cancel()


#: Where blocks are played. `next` raises ProgramError if the program refuses its arguments.
Spread = Threads | Ray | Slurm


def spread_to(address: str | None, workers: int | None) -> Spread:
    """Return where to play: threads without an address, `slurm`, `slurm:local`, else a Ray cluster."""
    if address is None:
        return Threads(workers)
    if address in ("slurm", "slurm:local"):
        return Slurm(address == "slurm:local", workers)
    return Ray(address, workers)
