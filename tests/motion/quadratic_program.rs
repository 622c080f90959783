//! Reference solution of the quadratic program of a recovery step: it tries every combination of active bounds.

use bica_motion::model::Parameters;
use bica_motion::walk::recovery::Situation;
use glam::Vec2;
use nalgebra::{SMatrix, SVector, matrix, vector};

/// Minimum time until a touchdown, s.
const MIN_REMAINING: f32 = 0.03;

/// Variables: displacement of the foot (2), growth of the divergent component of motion, its change at touchdown (2).
const N: usize = 5;
/// Number of variables with bounds: the first three.
const BOUNDED: usize = 3;
/// Number of equations between the variables.
const EQUATIONS: usize = 2;
/// Size of the system of the Karush-Kuhn-Tucker conditions.
const KKT: usize = N + EQUATIONS + BOUNDED;

/// Minimization of `½ xᵀ diag(weights) x - linearᵀ x` subject to `equation * x = constant` and to bounds of the first variables.
pub(crate) struct Program {
    weights: [f64; N],
    linear: [f64; N],
    equation: SMatrix<f64, EQUATIONS, N>,
    constant: SVector<f64, EQUATIONS>,
    bounds: [[f64; 2]; BOUNDED],
}

impl Program {
    /// Returns the program of a step in progress.
    pub(crate) fn of(gait: &Parameters, now: &Situation) -> Self {
        let growth = |remaining: f32| f64::from(now.frequency * remaining).exp();
        let earliest = (gait.min_recovery_duration - now.elapsed).max(MIN_REMAINING).min(now.remaining);
        let latest = (gait.max_recovery_duration - now.elapsed).max(now.remaining);
        let [place, time, offset] = gait.recovery_weights.map(f64::from);
        let exact = |Vec2 { x, y }: Vec2| [f64::from(x), f64::from(y)];
        let (dcm, wanted) = (exact(now.dcm), exact(now.place + now.offset));
        let outward = exact(gait.max_capture_step);
        let inward = exact(gait.max_capture_step.with_y(gait.max_inward_step));
        Self {
            weights: [place, place, time, offset, offset],
            linear: [0.0, 0.0, time * growth(now.remaining), 0.0, 0.0],
            // At touchdown: dcm * growth = wanted + displacement + change of the offset.
            equation: matrix![1.0, 0.0, -dcm[0], 1.0, 0.0; 0.0, 1.0, -dcm[1], 0.0, 1.0],
            constant: vector![-wanted[0], -wanted[1]],
            bounds: [[-inward[0], outward[0]], [-inward[1], outward[1]], [growth(earliest), growth(latest)]],
        }
    }

    /// Returns the displacement of the foot, m, and the time until touchdown, s.
    pub(crate) fn best_step(&self, now: &Situation) -> (Vec2, f32) {
        let best = self.solve();
        (Vec2::new(best[0] as f32, best[1] as f32), best[2].ln() as f32 / now.frequency)
    }

    /// Returns the minimum: the cheapest of the points whose derivative along the free variables is zero.
    fn solve(&self) -> SVector<f64, N> {
        let choices = (0..3_usize.pow(BOUNDED as u32)).map(|code| [code % 3, code / 3 % 3, code / 9]);
        let points = choices.filter_map(|active| self.point(active)).filter(|x| self.is_within(x));
        points.min_by(|a, b| self.cost(a).total_cmp(&self.cost(b))).expect("the bounds admit a solution")
    }

    /// Stationary point; each bounded variable is free (0), at its lower bound (1), or at its upper bound (2).
    fn point(&self, active: [usize; BOUNDED]) -> Option<SVector<f64, N>> {
        let (mut matrix, mut right) = (SMatrix::<f64, KKT, KKT>::zeros(), SVector::<f64, KKT>::zeros());
        for i in 0..N {
            matrix[(i, i)] = self.weights[i];
            right[i] = self.linear[i];
        }
        matrix.fixed_view_mut::<EQUATIONS, N>(N, 0).copy_from(&self.equation);
        matrix.fixed_view_mut::<N, EQUATIONS>(0, N).copy_from(&self.equation.transpose());
        right.fixed_rows_mut::<EQUATIONS>(N).copy_from(&self.constant);
        for (i, choice) in active.into_iter().enumerate() {
            let row = N + EQUATIONS + i;
            if choice == 0 {
                // The multiplier of a free variable is zero.
                matrix[(row, row)] = 1.0;
            } else {
                (matrix[(row, i)], matrix[(i, row)]) = (1.0, 1.0);
                right[row] = self.bounds[i][choice - 1];
            }
        }
        matrix.full_piv_lu().solve(&right).map(|x| x.fixed_rows::<N>(0).into_owned())
    }

    fn is_within(&self, x: &SVector<f64, N>) -> bool {
        self.bounds.iter().zip(x.iter()).all(|([low, high], x)| (low - 1e-9..=high + 1e-9).contains(x))
    }

    fn cost(&self, x: &SVector<f64, N>) -> f64 {
        (0..N).map(|i| (0.5 * self.weights[i] * x[i] - self.linear[i]) * x[i]).sum()
    }
}
