"""Optuna's study behind a search: samplers, candidates, their values."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from functools import partial

import optuna
from optuna.distributions import BaseDistribution, CategoricalDistribution, FloatDistribution, IntDistribution
from optuna.trial import FrozenTrial, Trial, TrialState

from bica.errors import BicaError
from bica.parameters import Setting
from bica.search.store import Store
from bica.search.study import Range, Study

#: What a violated constraint adds to an objective for CMA-ES, which has no constraints, per unit of the violation.
CMA_PENALTY = 1000.0

ENDED = (TrialState.COMPLETE, TrialState.PRUNED)


class StudyChangedError(BicaError):
    """A stored study does not belong to the study file."""


class Optimizer:
    """Candidates of a study in the database of the store. All methods wait for a database that is away."""

    def __init__(self, study: Study, store: Store) -> None:
        """Create the study, or continue it; candidates whose games had not ended are queued again."""
        optuna.logging.set_verbosity(optuna.logging.ERROR)
        warnings.filterwarnings("ignore", category=optuna.exceptions.ExperimentalWarning)
        warnings.filterwarnings("ignore", module="optuna", category=UserWarning)
        self.study, self.store = study, store
        self._optuna = store.patiently(self._open)
        self._distributions = {name: distribution(spread) for name, spread in study.parameters.items()}
        self._check()
        # A continued search draws other candidates than it began with.
        self._optuna.sampler = sampler(study, len(self.trials()))
        self._resume()

    def _open(self) -> optuna.Study:
        options = {} if self.store.is_local else {"pool_pre_ping": True}
        in_memory = self.store.is_in_memory
        return optuna.create_study(
            storage=None if in_memory else optuna.storages.RDBStorage(self.store.url, engine_kwargs=options),
            study_name=self.study.name,
            load_if_exists=True,
            directions=["minimize"] * len(self.study.objectives),
            pruner=optuna.pruners.MedianPruner(n_startup_trials=4, n_warmup_steps=(self.study.prune_after or 1) - 1),
        )

    def _check(self) -> None:
        stored = self._optuna.user_attrs.get("fingerprint")
        if stored not in (None, self.study.fingerprint) and not self.ended():
            # Nothing can be mixed: the study file was corrected before a candidate had ended.
            self.store.patiently(lambda: optuna.delete_study(study_name=self.study.name, storage=self._optuna._storage))
            self._optuna, stored = self.store.patiently(self._open), None
        if stored is None:
            self.store.patiently(lambda: self._optuna.set_user_attr("fingerprint", self.study.fingerprint))
        elif stored != self.study.fingerprint:
            raise StudyChangedError(
                f"the store has a study `{self.study.name}` with another program, objective, range, sampler or seeds\n"
                "  help: give the study another name, or use another store"
            )

    def _resume(self) -> None:
        """Queue the default first, and anew what was being played: games that are stored are not played again."""
        if not self.trials():
            default = {name: spread.default for name, spread in self.study.parameters.items()}
            self.store.patiently(lambda: self._optuna.enqueue_trial(default, skip_if_exists=True))
        for trial in self.trials():
            if trial.state == TrialState.RUNNING:
                if len(trial.params) == len(self.study.parameters):
                    self.store.patiently(partial(self._optuna.enqueue_trial, trial.params))
                self.finish(trial.number, TrialState.FAIL)

    def trials(self) -> list[FrozenTrial]:
        """Return all candidates, oldest first."""
        return self.store.patiently(lambda: self._optuna.get_trials(deepcopy=False))

    def ended(self) -> list[FrozenTrial]:
        """Return the candidates with all games, pruned, or refused by the program."""
        return [each for each in self.trials() if each.state in ENDED or "refused" in each.user_attrs]

    def ask(self) -> Trial:
        """Return the next candidate."""
        return self.store.patiently(lambda: self._optuna.ask(self._distributions))

    def settings(self, trial: Trial | FrozenTrial) -> dict[str, Setting]:
        """Return the values of a candidate as the program takes them."""
        return {name: spread.setting(trial.params[name]) for name, spread in self.study.parameters.items()}

    def report(self, trial: Trial, block: int, values: list[float], violations: Mapping[str, float]) -> bool:
        """Store the values after a block; returns whether the candidate should be pruned."""
        if self.study.prune_after is None:
            return False
        value = values[0] + CMA_PENALTY * _total(violations)
        self.store.patiently(lambda: trial.report(value, block))
        return block + 1 >= self.study.prune_after and self.store.patiently(trial.should_prune)

    def tell(self, trial: Trial, values: list[float], violations: Mapping[str, float], pruned: bool, games: int = 0) -> None:
        """End a candidate with its values over a number of games."""

        def describe() -> None:
            for name, violation in violations.items():
                if name not in trial.constraints:
                    trial.set_constraint(name, violation)
            trial.set_user_attr("values", values)
            trial.set_user_attr("violation", _total(violations))
            trial.set_user_attr("games", games)

        self.store.patiently(describe)
        if pruned:
            self.finish(trial.number, TrialState.PRUNED)
        else:
            penalty = CMA_PENALTY * _total(violations) if self.study.sampler.kind == "cma-es" else 0.0
            self.finish(trial.number, TrialState.COMPLETE, [value + penalty for value in values])

    def fail(self, trial: Trial, why: str) -> None:
        """End a candidate that the program refuses, or that has no value."""
        self.store.patiently(lambda: trial.set_user_attr("refused", why))
        self.finish(trial.number, TrialState.FAIL)

    def finish(self, number: int, state: TrialState, values: list[float] | None = None) -> None:
        """End a candidate; harmless if it has ended already, because the database was away after it had stored that."""
        self.store.patiently(lambda: self._optuna.tell(number, values, state, skip_if_finished=True))

    def best(self) -> FrozenTrial | None:
        """Return the candidate with the least first objective that violates nothing; None without any."""
        complete = [trial for trial in self.trials() if trial.state == TrialState.COMPLETE]
        feasible = [trial for trial in complete if trial.user_attrs.get("violation", 0.0) <= 0]
        return min(feasible, key=lambda trial: trial.user_attrs["values"][0], default=None)

    def importance(self) -> dict[str, float]:
        """Return the importance of each parameter for the first objective; empty with too few candidates."""
        try:
            return optuna.importance.get_param_importances(self._optuna, target=lambda trial: float(trial.user_attrs["values"][0]))
        except (ValueError, RuntimeError, ZeroDivisionError):
            return {}


def _total(violations: Mapping[str, float]) -> float:
    return sum(max(0.0, each) for each in violations.values())


def sampler(study: Study, candidates: int) -> optuna.samplers.BaseSampler:
    """Return Optuna's sampler of a study that has a number of candidates."""
    kind, seed = study.sampler.kind, study.sampler.seed + candidates
    if kind == "cma-es":
        return optuna.samplers.CmaEsSampler(seed=seed, consider_pruned_trials=True)
    if kind == "nsga-ii":
        return optuna.samplers.NSGAIISampler(seed=seed, population_size=max(4, min(50, study.sampler.candidates // 4)))
    if kind == "random":
        return optuna.samplers.RandomSampler(seed=seed)
    return optuna.samplers.TPESampler(seed=seed, multivariate=True, constant_liar=True)


def distribution(spread: Range) -> BaseDistribution:
    """Return Optuna's distribution of a range."""
    if spread.variants:
        return CategoricalDistribution(spread.variants)
    if spread.kind == "f32":
        return FloatDistribution(spread.minimum, spread.maximum, log=spread.log)
    return IntDistribution(int(spread.minimum), int(spread.maximum), log=spread.log)
