//! Renaming: complete, or refused with the places that cannot be decided.

use bica_vicode::{Target, read, uses};

use crate::keeping::edited;

/// A component `A` with code in another function.
fn file(code: &str, items: &str) -> String {
    format!(
        "pub struct A {{ other: Other, same: Box<A> }}\n\n/// See [`A::one`].\n#[component]\nimpl A {{\n    \
         #[state(initial, last)]\n    pub fn one(&mut self) {{}}\n\n    /// Not [`Other::one`], but [one](Self::one).\n    \
         fn step_2(&mut self, k: &Self, ball: &Other) {{\n        {code}\n    }}\n}}\n\n{items}\n"
    )
}

fn rename(text: &str) -> Result<String, String> {
    edited(text, r#"{"edit": "rename", "component": "A", "function": "one", "to": "two"}"#)
}

#[test]
fn rename_covers_known_types_and_leaves_namesakes() {
    for (code, items) in [
        ("(self).$(); (&mut *self).$(); self.$::<4>();", ""),
        ("k.$(); let x: &A = k; x.$(); let y = A::new(); y.$(); A::new().$();", ""),
        ("<Self>::$(self); <A>::$(self); Self::$(self); crate::A::$(self);", ""),
        (
            "Alias::$(self); Renamed::$(self); b::A::one();",
            "type Alias = A;\nuse self::A as Renamed;\nmod b { pub struct A; }",
        ),
        ("ball.one(); self.other.one(); self.same.$(); 1.one(); Other::one(); Other::new().one();", ""),
        (
            "self.same\n // c\n . $ (); dbg!(self.same.$());",
            "struct W(A, Other); impl W { fn f(&self) { self.0.$(); self.1.one(); } }",
        ),
        ("struct A; impl A { fn one(&self) { self.one(); Self::one(self) } } A::one(&A); k.$(); self::A::$(k);", ""),
        ("use other::A; A::one(k); k.$(); { use crate::A as B; B::$(k); }", "use A as Q; fn g(q: Q) { q.$() }"),
        ("", "/// [`Self::one`]\n#[doc = \"[`A::$`], [`Other::one`]\"]\nstruct S; /** A::$ */ enum E {}"),
        ("", "mod x { pub struct A; } mod y { use super::x::*; fn f(a: &A) { a.one() } }"),
        ("", "trait One { fn one(&self); fn more(&self) { self.one(); Self::one(self) } }"),
        ("", "activation_tree! { struct T { root: A, cycle_hz: 1, components: [A = A::$(), Other = Other::one()] } }"),
        ("", "#[params(check = A::$)]\nstruct P;\nmacro_rules! m { () => { A::$(); one!(one: one) } }"),
        ("{ let q = Other; q.one(); } fn f(q: &A) { q.$(); }", ""),
        ("matches!(1, 1 if self.$() && self.same.$() && k.$() && A::$(k) && ball.one() && one && Other::one());", ""),
        ("println!(\"{}\", self.$(), k.$(), ball.one(), A::$());", ""),
        (
            "",
            "mod other { pub struct A; impl A { fn one(&self) { self.one(); A::one(self); super::A::$(); } }\n fn f(a: &A) { a.one() } }",
        ),
        ("", "mod inner { use super::*;\n fn f(a: &A) { a.$(); A::$(a) } }"),
        (
            "",
            "trait One { fn one(&self); }\nimpl One for Other { fn one(&self) { self.one() } }\nimpl A { fn g(&self) { self.$() } }",
        ),
    ] {
        let text = file(&code.replace('$', "one"), &items.replace('$', "one"));
        let expected = file(&code.replace('$', "two"), &items.replace('$', "two"));
        let expected = expected.replacen("fn one", "fn two", 1).replace("[`A::one`]", "[`A::two`]");
        let expected = expected.replace("(Self::one)", "(Self::two)");
        assert_eq!(rename(&text).as_deref(), Ok(&*expected), "{code} {items}");
    }
}

#[test]
fn rename_lists_undecided_places() {
    for (code, lines) in [
        ("for x in all() { x.one(); }", "line 11"),
        ("let z = get();\n        z.one();\n        get().one();", "lines 12, 13"),
        ("let k = get(); k.one();", "line 11"),
        ("[1].map(|q| q.one());", "line 11"),
        ("self.unknown.one(); self.unknown.one();", "line 11"),
        ("} fn f(d: &D) { d.one();", "line 11"),
        ("} } macro_rules! m { ($x:expr) => { $x.one() } }\n fn g() { { ", "line 11"),
        ("self.n + ;\n        let k = = A::one(self);", "line 12"),
        ("} }\n struct W<T>(T); impl<T> W<T> { fn f(&self) { self.0.one();", "line 12"),
    ] {
        let message = rename(&file(code, "struct D(A); impl Deref for D {}")).expect_err(code);
        assert!(message.starts_with(&format!("{lines} may use `A::one`")), "{code}: {message}");
    }
}

#[test]
fn function_with_several_definitions_is_not_renamed() {
    for item in ["impl A { #[cfg(test)] fn one(&self) {} }", "impl A<5> { fn one(&self) {} }"] {
        let message = rename(&file("", item)).expect_err(item);
        assert!(message.starts_with("`one` has several definitions, in lines 7, 15"), "{message}");
    }
    let twice = file("} #[cfg(a)] fn one(&self) {", "");
    let edit = r#"{"edit": "set_body", "component": "A", "function": "one", "body": ""}"#;
    assert_eq!(edited(&twice, edit).unwrap_err(), "`one` is written twice in this block: change it in the code");
}

#[test]
fn namesakes_make_uses_of_other_files_undecided() {
    let home = file("", "type Alias = A;");
    let other = "use crate::home::{A, Alias};\nuse crate::else_where::B;\n\
        fn f(a: &A, b: &B) { A::one(a); Alias::one(a); a.one(); b.one(); x().one(); }\n";
    let certain = |has_namesakes| {
        let target = Target::new(&home, &read(&home).components[0], has_namesakes);
        uses(other, &target, "one", false).into_iter().map(|one| one.certain).collect::<Vec<_>>()
    };
    assert_eq!(certain(false), [true, true, true, false]);
    assert_eq!(certain(true), [false, false, false, false]);
}
