//! Tables of numbers in constants, such as the keyframes of a motion: rows that are calls, struct literals, or lists of pairs of a
//! name and a number.

use syn::{Expr, ExprArray, GenericArgument, Member, PathArguments, Type};

use crate::number;

/// The value of a constant as a table.
pub struct Table<'a> {
    /// Array of the rows; `None` for a constant that is one row itself.
    pub array: Option<&'a ExprArray>,
    /// The rows, in order.
    pub rows: Vec<Row<'a>>,
}

/// A row.
pub struct Row<'a> {
    /// The expression.
    pub expr: &'a Expr,
    /// The list, if the row is a list of pairs.
    pub pairs: Option<&'a ExprArray>,
    /// What is written in it, in order.
    pub cells: Vec<Cell<'a>>,
}

/// A number in a row, or the name of a constant in its place.
pub struct Cell<'a> {
    /// Names of fields, and positions of arguments and elements from 0, with dots between; in a list of pairs the name of the pair.
    pub name: String,
    /// The expression.
    pub expr: &'a Expr,
    /// The number; `None` for the name of a constant.
    pub value: Option<f64>,
}

/// Type of the rows of a table, and the length that its array must have.
pub struct Rows<'a> {
    /// Name of the type, without its path.
    pub name: String,
    /// Length of the array; `None` for a slice and for one row.
    pub length: Option<&'a Expr>,
}

impl<'a> Table<'a> {
    /// The table that an expression is; `None` if it is none.
    #[must_use]
    pub fn of(value: &'a Expr) -> Option<Self> {
        match plain(value) {
            Expr::Array(array) => {
                let rows = array.elems.iter().map(Row::of).collect::<Option<_>>()?;
                Some(Self { array: Some(array), rows })
            }
            _ => Some(Self { array: None, rows: vec![Row::of(value).filter(|row| row.pairs.is_none())?] }),
        }
    }
}

impl<'a> Rows<'a> {
    /// The rows of a table of type `ty`; `None` if no table has this type.
    #[must_use]
    pub fn of(ty: &'a Type) -> Option<Self> {
        match ty {
            Type::Reference(reference) => Self::of(&reference.elem),
            Type::Paren(paren) => Self::of(&paren.elem),
            Type::Group(group) => Self::of(&group.elem),
            Type::Slice(slice) => Self::of(&slice.elem).map(|rows| Self { length: None, ..rows }),
            Type::Array(array) => Self::of(&array.elem).map(|rows| Self { length: Some(&array.len), ..rows }),
            Type::Path(path) => {
                let last = path.path.segments.last()?;
                let is_lifetime = |argument: &GenericArgument| matches!(argument, GenericArgument::Lifetime(_));
                let is_plain = match &last.arguments {
                    PathArguments::AngleBracketed(arguments) => arguments.args.iter().all(is_lifetime),
                    _ => true,
                };
                is_plain.then(|| Self { name: last.ident.to_string(), length: None })
            }
            _ => None,
        }
    }
}

impl<'a> Row<'a> {
    fn of(expr: &'a Expr) -> Option<Self> {
        let inner = plain(expr);
        if let Expr::Array(list) = inner {
            let cells = list.elems.iter().map(pair).collect::<Option<_>>()?;
            return Some(Self { expr, pairs: Some(list), cells });
        }
        let mut cells = Vec::new();
        if matches!(inner, Expr::Call(_) | Expr::Struct(_)) {
            collect(inner, "", &mut cells);
        }
        cells.iter().any(|cell| cell.value.is_some()).then_some(Self { expr, pairs: None, cells })
    }
}

/// `(Name, 1.0)`
fn pair(expr: &Expr) -> Option<Cell<'_>> {
    let Expr::Tuple(tuple) = expr else { return None };
    let mut parts = tuple.elems.iter();
    let (Some(Expr::Path(name)), Some(expr), None) = (parts.next(), parts.next(), parts.next()) else { return None };
    let name = name.path.segments.last()?.ident.to_string();
    Some(Cell { name, expr, value: Some(number::value(expr)?) })
}

fn collect<'a>(expr: &'a Expr, name: &str, cells: &mut Vec<Cell<'a>>) {
    let below = |part: &str| if name.is_empty() { part.to_owned() } else { format!("{name}.{part}") };
    let mut all = |parts: &mut dyn Iterator<Item = &'a Expr>| {
        parts.enumerate().for_each(|(index, part)| collect(part, &below(&index.to_string()), cells));
    };
    match plain(expr) {
        Expr::Call(call) => all(&mut call.args.iter()),
        Expr::Array(array) => all(&mut array.elems.iter()),
        Expr::Tuple(tuple) => all(&mut tuple.elems.iter()),
        Expr::Struct(literal) => {
            for field in &literal.fields {
                let part = match &field.member {
                    Member::Named(name) => name.to_string(),
                    Member::Unnamed(index) => index.index.to_string(),
                };
                collect(&field.expr, &below(&part), cells);
            }
        }
        inner @ Expr::Path(_) => cells.push(Cell { name: name.to_owned(), expr: inner, value: None }),
        inner => cells.extend(number::value(inner).map(|value| Cell {
            name: name.to_owned(),
            expr: inner,
            value: Some(value),
        })),
    }
}

fn plain(expr: &Expr) -> &Expr {
    match expr {
        Expr::Reference(reference) => plain(&reference.expr),
        Expr::Paren(paren) => plain(&paren.expr),
        Expr::Group(group) => plain(&group.expr),
        expr => expr,
    }
}

#[cfg(test)]
mod tests {
    use syn::parse_quote;

    use super::*;

    /// The texts of the cells of each row, with their numbers.
    type Cells = Vec<Vec<(String, Option<f64>)>>;

    fn cells(expr: &Expr) -> Option<Cells> {
        let row = |row: &Row<'_>| row.cells.iter().map(|cell| (cell.name.clone(), cell.value)).collect();
        Table::of(expr).map(|table| table.rows.iter().map(row).collect())
    }

    #[test]
    fn numbers_are_named_by_field_position_or_pair() {
        let named =
            |cells: &[(&str, f64)]| cells.iter().map(|(name, value)| ((*name).to_owned(), Some(*value))).collect();
        let calls: Expr = parse_quote!([Frame::new(36, [0, -2]), Frame::new(4_0, [1, (2)])]);
        let expected =
            vec![named(&[("0", 36.0), ("1.0", 0.0), ("1.1", -2.0)]), named(&[("0", 40.0), ("1.0", 1.0), ("1.1", 2.0)])];
        assert_eq!(cells(&calls), Some(expected));
        let literal: Expr = parse_quote!(Key { seconds: 1.0, pose: STAND });
        assert_eq!(cells(&literal), Some(vec![vec![("seconds".into(), Some(1.0)), ("pose".into(), None)]]));
        let pairs: Expr = parse_quote!(&[&[(Arm, -61.0), (Joint::Leg, 90.)], &[]]);
        assert_eq!(cells(&pairs), Some(vec![named(&[("Arm", -61.0), ("Leg", 90.0)]), Vec::new()]));
    }

    #[test]
    fn what_has_no_rows_of_numbers_is_no_table() {
        let others: [Expr; 4] =
            [parse_quote!([1, 2]), parse_quote!(f(x)), parse_quote!([f(1), other]), parse_quote!(&[(Arm, "up")])];
        assert!(others.iter().all(|expr| Table::of(expr).is_none()));
    }

    #[test]
    fn the_type_names_the_rows() {
        let types: [Type; 4] = [
            parse_quote!([Frame; 7]),
            parse_quote!(&'static [model::Frame]),
            parse_quote!(Frame<'static>),
            parse_quote!(Joints<Range>),
        ];
        let named: Vec<_> =
            types.iter().map(|ty| Rows::of(ty).map(|rows| (rows.name, rows.length.is_some()))).collect();
        let frame = |fixed| Some(("Frame".to_owned(), fixed));
        assert_eq!(named, [frame(true), frame(false), frame(false), None]);
    }
}
