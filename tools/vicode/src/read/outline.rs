//! Nesting of items, blocks and functions.

use syn::visit::{self, Visit};
use syn::{Block, ImplItemFn, Item, ItemImpl, ItemMod, Macro, Signature, Stmt, TraitItemFn, TypeParam};

use super::Source;
use crate::model::Span;

/// Regions of a text in its order, each before the regions within it.
pub(crate) struct Outline<'a> {
    pub(crate) source: &'a Source<'a>,
    pub(crate) regions: Vec<Region<'a>>,
    /// Type parameters, each with the region that declares it.
    pub(crate) parameters: Vec<(&'a TypeParam, usize)>,
    pub(crate) macros: Vec<&'a Macro>,
    open: Option<usize>,
}

/// A part of a text that may contain others.
pub(crate) struct Region<'a> {
    pub(crate) span: Span,
    pub(crate) node: Node<'a>,
    /// Index of the region that contains it.
    pub(crate) parent: Option<usize>,
}

/// Kind of a region.
#[derive(Clone)]
pub(crate) enum Node<'a> {
    /// The items of the file or of a module.
    Module(Vec<&'a Item>),
    /// The items of a block.
    Block(Vec<&'a Item>),
    /// An item.
    Item(&'a Item),
    /// A function of an impl block or of a trait.
    Method(&'a Signature),
}

impl<'a> Outline<'a> {
    pub(crate) fn of(source: &'a Source<'a>) -> Self {
        let (regions, parameters, macros) = (Vec::new(), Vec::new(), Vec::new());
        let mut outline = Self { source, regions, parameters, macros, open: None };
        let items = Node::Module(source.file.items.iter().collect());
        outline.enter(Span::new(0, source.text.len()), items, |outline| visit::visit_file(outline, &source.file));
        outline
    }

    fn enter(&mut self, span: Span, node: Node<'a>, inside: impl FnOnce(&mut Self)) {
        let outer = self.open.replace(self.regions.len());
        self.regions.push(Region { span, node, parent: outer });
        inside(self);
        self.open = outer;
    }

    /// Returns the regions around a place, the innermost first.
    pub(crate) fn around(&self, at: usize) -> impl Iterator<Item = usize> + '_ {
        let innermost = self.regions.iter().rposition(|region| region.span.contains(Span::at(at)));
        self.outwards(innermost)
    }

    /// Returns a region and those around it.
    pub(crate) fn outwards(&self, region: Option<usize>) -> impl Iterator<Item = usize> + '_ {
        std::iter::successors(region, |region| self.parent(*region))
    }

    /// Returns the region around another one.
    pub(crate) fn parent(&self, region: usize) -> Option<usize> {
        self.regions.get(region)?.parent
    }

    /// Returns the items of a module or of a block; `None` for other regions.
    pub(crate) fn items(&self, region: usize) -> Option<&[&'a Item]> {
        match &self.regions[region].node {
            Node::Module(items) | Node::Block(items) => Some(items),
            _ => None,
        }
    }

    /// Returns the innermost module at a place, else the file.
    pub(crate) fn module(&self, at: usize) -> usize {
        self.around(at).find(|region| matches!(self.regions[*region].node, Node::Module(_))).unwrap_or_default()
    }

    /// Returns the path of the modules and functions around a region, as `one::two`.
    pub(crate) fn path(&self, region: usize) -> String {
        let name = |region: usize| match self.regions[region].node {
            Node::Item(Item::Mod(item)) => Some(item.ident.to_string()),
            Node::Item(Item::Fn(item)) => Some(item.sig.ident.to_string()),
            Node::Method(signature) => Some(signature.ident.to_string()),
            _ => None,
        };
        let mut names: Vec<String> = self.outwards(Some(region)).filter_map(name).collect();
        names.reverse();
        names.join("::")
    }

    /// Returns the functions of impl blocks, each with its region and the region of its block.
    pub(crate) fn methods(&self) -> impl Iterator<Item = (&'a Signature, usize, usize)> + '_ {
        self.regions.iter().enumerate().filter_map(|(index, region)| match (&region.node, region.parent) {
            (Node::Method(signature), Some(block)) if self.block(block).is_some() => Some((*signature, index, block)),
            _ => None,
        })
    }

    /// Returns the impl block of a region.
    pub(crate) fn block(&self, region: usize) -> Option<&'a ItemImpl> {
        if let Node::Item(Item::Impl(block)) = self.regions[region].node { Some(block) } else { None }
    }
}

impl<'a> Visit<'a> for Outline<'a> {
    fn visit_item(&mut self, item: &'a Item) {
        self.enter(self.source.item(item), Node::Item(item), |outline| visit::visit_item(outline, item));
    }

    fn visit_item_mod(&mut self, item: &'a ItemMod) {
        let Some((braces, items)) = &item.content else { return };
        let brackets = braces.span;
        let span = Span::new(self.source.of(&brackets.open()).end, self.source.of(&brackets.close()).start);
        self.enter(span, Node::Module(items.iter().collect()), |outline| visit::visit_item_mod(outline, item));
    }

    fn visit_block(&mut self, block: &'a Block) {
        let items = block.stmts.iter().filter_map(|one| if let Stmt::Item(item) = one { Some(item) } else { None });
        let span = self.source.of(&block.brace_token.span.join());
        self.enter(span, Node::Block(items.collect()), |outline| visit::visit_block(outline, block));
    }

    fn visit_impl_item_fn(&mut self, item: &'a ImplItemFn) {
        let node = Node::Method(&item.sig);
        self.enter(self.source.item(item), node, |outline| visit::visit_impl_item_fn(outline, item));
    }

    fn visit_trait_item_fn(&mut self, item: &'a TraitItemFn) {
        let node = Node::Method(&item.sig);
        self.enter(self.source.item(item), node, |outline| visit::visit_trait_item_fn(outline, item));
    }

    fn visit_macro(&mut self, call: &'a Macro) {
        self.macros.push(call);
    }

    fn visit_type_param(&mut self, parameter: &'a TypeParam) {
        self.parameters.extend(self.open.map(|region| (parameter, region)));
    }
}
