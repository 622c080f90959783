//! Constants that are tables of numbers, and functions that return one for each variant.

use std::collections::BTreeMap;

use bica_syntax::table::{Row as SyntaxRow, Rows, Table as Syntax};
use bica_syntax::text::written;
use proc_macro2::Ident;
use syn::visit::{self, Visit};
use syn::{Arm, Attribute, Block, Expr, ImplItemConst, ItemConst, ItemFn, ItemStatic, ReturnType, Stmt, Type};

use super::{Source, docs};
use crate::model::{Cell, Name, Row, Span, Table};

/// Returns the tables of a file, in the order of the text.
pub(super) fn tables(source: &Source<'_>) -> Vec<Table> {
    let mut finder = Finder { source, found: Vec::new() };
    finder.visit_file(&source.file);
    let mut numbers: BTreeMap<String, u32> = BTreeMap::new();
    for Table { key, name, .. } in &mut finder.found {
        let number = numbers.entry(name.text.clone()).or_default();
        *number += 1;
        *key = if *number > 1 { format!("{}#{number}", name.text) } else { name.text.clone() };
    }
    finder.found
}

struct Finder<'a> {
    source: &'a Source<'a>,
    found: Vec<Table>,
}

impl Finder<'_> {
    fn constant(&mut self, name: &Ident, ty: &Type, value: &Expr, attributes: &[Attribute], span: Span) {
        let name = self.source.name(name);
        let found = Rows::of(ty).and_then(|rows| self.table(name, &rows, value));
        self.found.extend(found.map(|table| Table { docs: docs::docs(self.source, attributes), span, ..table }));
    }

    fn table(&self, name: Name, rows: &Rows<'_>, value: &Expr) -> Option<Table> {
        let table = Syntax::of(value)?;
        let array = match table.array {
            Some(array) => Some(self.source.within(&array.bracket_token.span)?),
            None => None,
        };
        Some(Table {
            name,
            ty: rows.name.clone(),
            array,
            length: rows.length.map(|length| self.source.of(length)),
            rows: table.rows.iter().map(|row| self.row(row)).collect(),
            ..Table::default()
        })
    }

    fn row(&self, row: &SyntaxRow<'_>) -> Row {
        let cell = |cell: &bica_syntax::table::Cell<'_>| Cell {
            name: cell.name.clone(),
            span: self.source.of(cell.expr),
            value: cell.value,
        };
        Row {
            span: self.source.of(row.expr),
            pairs: row.pairs.and_then(|list| self.source.within(&list.bracket_token.span)),
            cells: row.cells.iter().map(cell).collect(),
        }
    }

    /// Returns the table of a `match` arm.
    fn arm(&self, arm: &Arm, rows: &Rows<'_>) -> Option<Table> {
        let pattern = written(&arm.pat);
        let name = Name { text: pattern.rsplit("::").next()?.trim().to_owned(), span: self.source.of(&arm.pat) };
        let value = match &*arm.body {
            Expr::Block(block) => tail(&block.block)?,
            value => value,
        };
        self.table(name, rows, value).map(|table| Table { span: self.source.of(arm), ..table })
    }
}

impl<'a> Visit<'a> for Finder<'_> {
    fn visit_item_const(&mut self, item: &'a ItemConst) {
        self.constant(&item.ident, &item.ty, &item.expr, &item.attrs, self.source.item(item));
    }

    fn visit_impl_item_const(&mut self, item: &'a ImplItemConst) {
        self.constant(&item.ident, &item.ty, &item.expr, &item.attrs, self.source.item(item));
    }

    fn visit_item_static(&mut self, item: &'a ItemStatic) {
        self.constant(&item.ident, &item.ty, &item.expr, &item.attrs, self.source.item(item));
    }

    fn visit_item_fn(&mut self, item: &'a ItemFn) {
        if let (ReturnType::Type(_, ty), Some(Expr::Match(choice))) = (&item.sig.output, tail(&item.block))
            && let Some(rows) = Rows::of(ty)
        {
            let found: Vec<Table> = choice.arms.iter().filter_map(|arm| self.arm(arm, &rows)).collect();
            self.found.extend(found);
        }
        visit::visit_item_fn(self, item);
    }
}

/// Returns the value of a block.
fn tail(block: &Block) -> Option<&Expr> {
    if let Some(Stmt::Expr(value, None)) = block.stmts.last() { Some(value) } else { None }
}
