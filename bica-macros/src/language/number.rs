//! Rates and budgets.

use syn::{Expr, ExprLit, Lit};

use crate::language::report::Report;
use crate::language::wording;

/// A positive number, written whole or with a fraction; `None` with a mistake reported if it is not.
pub(crate) fn positive(value: &Expr, key: &str, report: &mut Report) -> Option<f32> {
    let number = match plain(value) {
        Expr::Lit(ExprLit { lit: Lit::Int(number), .. }) => number.base10_parse::<f32>().ok(),
        Expr::Lit(ExprLit { lit: Lit::Float(number), .. }) => number.base10_parse::<f32>().ok(),
        _ => None,
    };
    match number {
        Some(number) if number > 0.0 && number.is_finite() => Some(number),
        Some(_) => {
            report.add(value, wording::not_positive(key));
            None
        }
        None => {
            report.add(value, wording::no_number(key));
            None
        }
    }
}

/// The expression without the invisible brackets that a `macro_rules` macro puts around it.
fn plain(mut value: &Expr) -> &Expr {
    while let Expr::Group(group) = value {
        value = &group.expr;
    }
    value
}
