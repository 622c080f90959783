//! Masses.

use crate::model::{Mass, Masses};

/// Masses of the V6. Source: B-Human 2023 `robotDimensions.cfg`; HULKs 2025 `robot_masses.rs` has the same.
pub(super) const MASSES: Masses = Masses::symmetric(
    [
        Mass::grams(1049.60, -4.13, 0.0, 128.42),
        Mass::grams(78.42, -0.01, 0.0, -27.42),
        Mass::grams(659.37, 1.09, 1.46, 57.19),
    ],
    [
        Mass::grams(93.04, -1.65, -26.63, 0.14),
        Mass::grams(157.77, 24.55, 5.63, 3.30),
        Mass::grams(64.83, -27.44, 0.0, -0.14),
        Mass::grams(77.61, 25.56, 2.81, 0.76),
        Mass::grams(185.33, 34.34, -0.88, 3.08),
    ],
    [
        Mass::grams(69.81, -7.81, -11.14, 26.61),
        Mass::grams(140.53, -15.49, 0.29, -5.15),
        Mass::grams(389.68, 1.38, 2.21, -53.73),
        Mass::grams(301.42, 4.53, 2.25, -49.36),
        Mass::grams(134.16, 0.45, 0.29, 6.85),
        Mass::grams(171.84, 25.42, 3.30, -32.39),
    ],
);
