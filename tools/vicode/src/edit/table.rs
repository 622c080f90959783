//! Numbers and rows of tables of constants.

use super::context::{Context, list};
use super::request::{NewNumber, Refusal};
use super::splice::Splice;
use crate::model::{Row, Span, Table};

/// Largest number of written decimals.
const DECIMALS: usize = 6;

fn find<'a>(context: &Context<'a>, key: &str) -> Result<&'a Table, Refusal> {
    let tables = &context.model.tables;
    tables.iter().find(|table| table.key == key).ok_or_else(|| {
        let known = list(tables.iter().map(|table| &*table.key));
        Refusal::new(format!("no table `{key}` is in this file: there is {known}"))
    })
}

fn row(table: &Table, index: usize) -> Result<&Row, Refusal> {
    let number = table.rows.len();
    let none = || Refusal::at(table.name.span, format!("`{}` has {number} rows: there is no row {index}", table.key));
    table.rows.get(index).ok_or_else(none)
}

/// Sets numbers.
pub(super) fn set(context: &Context<'_>, key: &str, numbers: &[NewNumber]) -> Result<Vec<Splice>, Refusal> {
    let table = find(context, key)?;
    let mut splices = Vec::new();
    let is_other = |one: &&NewNumber| {
        let pairs = table.rows.get(one.row).filter(|row| row.pairs.is_some());
        pairs.is_some_and(|row| row.cell(&one.cell).is_none() == one.value.is_some())
    };
    let mut other: Vec<usize> = numbers.iter().filter(is_other).map(|one| one.row).collect();
    other.sort_unstable();
    // A row that gains or loses several pairs is rewritten.
    let anew = |row: usize| other.iter().filter(|one| **one == row).count() > 1;
    let mut rows: Vec<usize> = other.iter().copied().filter(|row| anew(*row)).collect();
    rows.dedup();
    for index in rows {
        let numbers: Vec<&NewNumber> = numbers.iter().filter(|one| one.row == index).collect();
        splices.push(pairs(context.text, &table.rows[index], &numbers)?);
    }
    for NewNumber { row: index, cell, value } in numbers.iter().filter(|one| !anew(one.row)) {
        let row = row(table, *index)?;
        let is_finite = value.is_none_or(f64::is_finite);
        match (row.cell(cell), value) {
            _ if !is_finite => return Err(infinite(row)),
            (Some(old), Some(value)) if old.value.is_some() => {
                let written = number(old.span.of(context.text), *value);
                splices.extend((old.value != Some(*value)).then(|| Splice::new(old.span, written)));
            }
            (Some(old), Some(_)) => {
                let name = old.span.of(context.text);
                return Err(Refusal::at(old.span, format!("`{name}` is not a number: change its constant")));
            }
            (Some(_), None) if row.pairs.is_some() => splices.push(without(context.text, row, cell)),
            (None, Some(value)) if row.pairs.is_some() => splices.push(with(context.text, row, cell, *value)?),
            (None, None) if row.pairs.is_some() => {}
            _ => {
                let known = list(row.cells.iter().map(|cell| &*cell.name));
                return Err(Refusal::at(row.span, format!("row {index} has no number `{cell}`: there is {known}")));
            }
        }
    }
    Ok(splices)
}

/// Formats a number like the one that it replaces: as an integer if that is one, else with at least as many decimals.
fn number(old: &str, value: f64) -> String {
    let Some((_, fraction)) = old.split_once('.') else { return format!("{}", value.round() as i64) };
    let scale = 10_f64.powi(DECIMALS as i32);
    // Adding 0 turns -0 into 0.
    let value = (value * scale).round() / scale + 0.0;
    let shortest = format!("{value}");
    let (whole, digits) = shortest.split_once('.').unwrap_or((&shortest, ""));
    let places = fraction.chars().filter(char::is_ascii_digit).count();
    let mut digits = format!("{digits:0<places$}");
    if fraction.contains('_') {
        let groups: Vec<&str> =
            (0..digits.len()).step_by(3).map(|at| &digits[at..(at + 3).min(digits.len())]).collect();
        digits = groups.join("_");
    }
    format!("{whole}.{digits}")
}

/// Rewrites the pairs of a row: kept ones in their order, then new ones.
fn pairs(text: &str, row: &Row, numbers: &[&NewNumber]) -> Result<Splice, Refusal> {
    let of = |name: &str| numbers.iter().find(|one| one.cell == name).map(|one| one.value);
    let mut all = Vec::new();
    for (index, cell) in row.cells.iter().enumerate() {
        let old = cell.span.of(text);
        let value = of(&cell.name).unwrap_or(cell.value);
        let Some(value) = value else { continue };
        let value = if cell.value == Some(value) { old.to_owned() } else { number(old, value) };
        let name = Span::new(begin(text, row, index), cell.span.start).of(text);
        all.push(format!("{name}{value})"));
    }
    for one in numbers.iter().filter(|one| row.cell(&one.cell).is_none()) {
        if let Some(value) = one.value {
            all.push(pair(row, &one.cell, value)?);
        }
    }
    Ok(Splice::new(row.pairs.unwrap_or(row.span), all.join(", ")))
}

fn pair(row: &Row, name: &str, value: f64) -> Result<String, Refusal> {
    let wrong = |_| Refusal::at(row.span, format!("`{}` is not a name", name.escape_debug()));
    syn::parse_str::<syn::Ident>(name).map_err(wrong)?;
    if value.is_finite() { Ok(format!("({name}, {})", number("0.0", value))) } else { Err(infinite(row)) }
}

fn infinite(row: &Row) -> Refusal {
    Refusal::at(row.span, "a number must be finite")
}

/// Returns the offset of a pair: the last parenthesis before its number.
fn begin(text: &str, row: &Row, index: usize) -> usize {
    let (start, end) = (row.pairs.unwrap_or(row.span).start, row.cells[index].span.start);
    text[start..end].rfind('(').map_or(end, |at| start + at)
}

/// Adds a pair at the end of its row.
fn with(text: &str, row: &Row, name: &str, value: f64) -> Result<Splice, Refusal> {
    let within = row.pairs.unwrap_or(row.span);
    let pair = pair(row, name, value)?;
    let written = within.of(text).trim_end();
    let comma = if written.is_empty() {
        ""
    } else if written.ends_with(',') {
        " "
    } else {
        ", "
    };
    Ok(Splice::insert(within.start + written.len(), format!("{comma}{pair}")))
}

/// Removes a pair with the comma before or after it.
fn without(text: &str, row: &Row, name: &str) -> Splice {
    let within = row.pairs.unwrap_or(row.span);
    let index = row.cells.iter().position(|cell| cell.name == name).unwrap_or_default();
    // A pair ends at the next parenthesis after its number.
    let end = |index: usize| {
        let start = row.cells[index].span.end;
        text[start..within.end].find(')').map_or(start, |at| start + at + 1)
    };
    let span = match (row.cells.len() > index + 1, index) {
        (true, _) => Span::new(begin(text, row, index), begin(text, row, index + 1)),
        (false, 0) => within,
        (false, _) => Span::new(end(index - 1), end(index)),
    };
    Splice::remove(span)
}

/// Inserts a row.
pub(super) fn insert(
    context: &Context<'_>,
    key: &str,
    before: usize,
    copy: Option<usize>,
    code: &str,
) -> Result<Vec<Splice>, Refusal> {
    let (table, text) = (find(context, key)?, context.text);
    let code = match copy {
        Some(copy) => row(table, copy)?.span.of(text),
        None => code.trim(),
    };
    if syn::parse_str::<syn::Expr>(code).is_err() {
        return Err(Refusal::new(format!("`{}` is not an expression: it cannot be a row", code.escape_debug())));
    }
    let array = array(table)?;
    let mut splices = length(context, table, table.rows.len() + 1)?;
    let rows = &table.rows;
    if let Some(indent) = too_long(context, array, code) {
        let mut all: Vec<&str> = rows.iter().map(|row| row.span.of(text)).collect();
        all.insert(before.min(rows.len()), code);
        let gap = format!("\n{indent}    ");
        let lines = all.join(&format!(",{gap}"));
        splices.push(Splice::new(array, format!("{gap}{lines},\n{indent}")));
        return Ok(splices);
    }
    splices.push(match (rows.get(before), rows.last()) {
        (Some(next), _) => Splice::insert(next.span.start, format!("{code},{}", above(text, array, next))),
        (None, Some(last)) => {
            let after = Span::new(last.span.end, array.end);
            let gap = above(text, array, last);
            if has_comma(text, after) {
                let at = after.start + after.of(text).trim_end().len();
                Splice::insert(at, format!("{gap}{code},"))
            } else {
                Splice::insert(after.start, format!(",{gap}{code}"))
            }
        }
        (None, None) => Splice::insert(array.start, code),
    });
    Ok(splices)
}

/// Returns the indentation of a one-line array that would be too long with another row; `None` if it fits or has a comment.
fn too_long<'a>(context: &Context<'a>, array: Span, code: &str) -> Option<&'a str> {
    let (text, written) = (context.text, array.of(context.text));
    let begin = text[..array.start].rfind('\n').map_or(0, |at| at + 1);
    let line = text[begin..].lines().next().unwrap_or_default();
    let is_long = !written.contains(['\n', '/']) && line.len() + code.len() + ", ".len() > context.width;
    is_long.then(|| &line[..line.len() - line.trim_start().len()])
}

/// Deletes a row.
pub(super) fn delete(context: &Context<'_>, key: &str, index: usize) -> Result<Vec<Splice>, Refusal> {
    let (table, text) = (find(context, key)?, context.text);
    let (array, own) = (array(table)?, row(table, index)?.span);
    let mut splices = length(context, table, table.rows.len() - 1)?;
    let comma = |span: Span| span.start + span.of(text).find(',').map_or(0, |at| at + 1);
    splices.push(Splice::remove(match (table.rows.get(index + 1), index.checked_sub(1)) {
        (Some(next), _) => {
            let between = Span::new(own.end, next.span.start);
            let is_plain = between.of(text).trim() == ",";
            Span::new(own.start, if is_plain { next.span.start } else { comma(between) })
        }
        (None, before) => {
            let after = Span::new(own.end, array.end);
            let has_comma = has_comma(text, after);
            let end = if has_comma { comma(after) } else { own.end };
            let gap = Span::new(array.start, own.start);
            let kept = gap.start + gap.of(text).trim_end().len();
            match before.map(|before| table.rows[before].span.end) {
                Some(last) if !has_comma => Span::new(last, end),
                _ => Span::new(kept, end),
            }
        }
    }));
    Ok(splices)
}

fn array(table: &Table) -> Result<Span, Refusal> {
    let none = || Refusal::at(table.name.span, format!("`{}` is one row: it cannot have more or less", table.key));
    table.array.ok_or_else(none)
}

/// Updates the length in the type of the constant.
fn length(context: &Context<'_>, table: &Table, rows: usize) -> Result<Vec<Splice>, Refusal> {
    let Some(span) = table.length else { return Ok(Vec::new()) };
    let written = span.of(context.text);
    if written.parse::<usize>().is_err() {
        let what = format!("the length of `{}` is `{written}`: write a number, or change it there first", table.key);
        return Err(Refusal::at(span, what));
    }
    Ok(vec![Splice::new(span, rows.to_string())])
}

/// Returns the separator before a row: line break and indentation, or a space.
fn above<'a>(text: &'a str, array: Span, row: &Row) -> &'a str {
    let before = Span::new(array.start, row.span.start).of(text);
    let gap = &before[before.trim_end().len()..];
    if gap.contains('\n') { gap } else { " " }
}

/// Returns whether a comma follows a row, before any comment.
fn has_comma(text: &str, after: Span) -> bool {
    after.of(text).trim_start().starts_with(',')
}
