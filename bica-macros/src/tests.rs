//! The expanders run as ordinary functions.

use proc_macro2::{TokenStream, TokenTree};
use quote::quote;
use syn::{File, Item, parse2};

use crate::{actions, component, params, plain_item, tree};

fn machine() -> TokenStream {
    quote! {
        impl Player {
            #[state(initial)]
            fn look(&mut self, search: &mut Search) {}

            #[state]
            fn walk(&mut self, legs: &mut Legs<4>, rate: &mut Rate<Legs<4>>) {}

            #[transition(look -> walk)]
            fn seen(&self, ball: &Ball, time: &Time) -> bool { true }

            #[transition(* -> look, after_ms = 5)]
            fn lost(&self) -> bool { true }

            #[entry(look | walk)]
            fn hello(&mut self, ball: &Ball) {}

            #[start]
            fn woke(&mut self) {}
        }
    }
}

fn forward() -> TokenStream {
    quote!(pub struct Forward { root: Player, cycle_hz: 100, components: [Player, Legs<4> = Legs::at(0), Ball] })
}

fn expanded(component: &TokenStream) -> File {
    parse2(component::run(quote!(hz = 30, resume), component)).expect("code")
}

fn words(tokens: TokenStream) -> Vec<String> {
    let word = |token| match token {
        TokenTree::Group(group) => words(group.stream()),
        other => vec![other.to_string()],
    };
    tokens.into_iter().flat_map(word).collect()
}

/// The messages of an expansion: the texts of its `compile_error!`.
fn messages(tokens: TokenStream) -> Vec<String> {
    let words = words(tokens);
    let errors = words.windows(3).filter(|three| three[0] == "compile_error");
    errors.map(|three| three[2].clone()).collect()
}

#[test]
fn role_attributes_are_removed_and_all_else_is_kept() {
    let file = expanded(&quote! {
        impl Head {
            const LIMIT: f32 = 1.0;
            /// Where it looks.
            #[inline]
            pub fn pan(&self) -> f32 { self.pan }
            #[stop]
            fn rest(&mut self) { self.pan = 0.0; }
        }
    });
    let Item::Impl(block) = &file.items[0] else { panic!("the block comes first") };
    let written = words(quote!(#block));
    assert!(!written.contains(&"stop".to_owned()) && written.contains(&"inline".to_owned()));
}

#[test]
fn run_functions_are_not_inlined_on_bare_metal() {
    let never = |block: &TokenStream| {
        let file = expanded(block);
        let Item::Impl(block) = &file.items[0] else { panic!("the block comes first") };
        words(quote!(#block)).iter().filter(|word| *word == "never").count()
    };
    assert_eq!(never(&quote!(impl Head { fn step(&mut self) {} fn pan(&self) -> f32 { 0.0 } })), 1);
    assert_eq!(never(&quote!(impl Head { #[inline(always)] fn step(&mut self) {} })), 0);
    assert_eq!(never(&machine()), 3, "two states and a hook that may write");
}

/// Only their names collide then.
#[test]
fn trees_at_two_places_share_only_their_name() {
    let items = |place| parse2::<File>(tree::run(forward(), place)).expect("code").items;
    let named = |items: Vec<Item>| {
        let name = |item: Item| match item {
            Item::Mod(item) => Some(item.ident.to_string()),
            Item::Use(item) => Some(words(quote!(#item)).concat()),
            Item::Const(item) if item.ident == "_" => None,
            other => panic!("{}", quote!(#other)),
        };
        items.into_iter().filter_map(name).collect::<Vec<_>>()
    };
    let (first, second) = (named(items((1, 1))), named(items((2, 1))));
    assert!(first[1].ends_with("::Forward;") && second[1].ends_with("::Forward;"), "{first:?}");
    assert!(first.iter().all(|name| !second.contains(name)), "{first:?}");
}

#[test]
fn generated_code_contains_no_unsafe() {
    for code in [component::run(quote!(), &machine()), tree::run(forward(), (1, 1))] {
        assert!(!words(code).contains(&"unsafe".to_owned()));
    }
}

/// The names in generated code that a user's own item could have: words of the language's libraries that no path precedes.
fn bare(code: TokenStream) -> Vec<String> {
    const NAMES: [&str; 30] = [
        "bool",
        "char",
        "str",
        "f32",
        "f64",
        "i32",
        "u8",
        "u16",
        "u32",
        "u64",
        "usize",
        "Option",
        "Some",
        "None",
        "Result",
        "Ok",
        "Err",
        "Default",
        "Clone",
        "Copy",
        "From",
        "Into",
        "Iterator",
        "Drop",
        "Vec",
        "panic",
        "assert",
        "matches",
        "unreachable",
        "std",
    ];
    let words = words(code);
    let is_bare = |three: &&[String]| NAMES.contains(&three[2].as_str()) && !(three[0] == ":" && three[1] == ":");
    words.windows(3).filter(is_bare).map(|three| three.join(" ")).collect()
}

#[test]
fn generated_code_names_everything_by_its_path() {
    let attributes = quote!(/** Docs. */ #[derive(Params)] #[params(check = rule)]);
    let params = quote!(#attributes struct P { /** Gain. */ #[param(default = 1, range = 0..=2, step = 1)] gain: Own, /** M. */ #[param(default = M::A)] mode: M });
    let operator = quote! {
        impl Head {
            fn step(&mut self, own: &Tuned<P>, rate: &mut Rate<Neck>, time: &Time) {}
            /// Angle.
            #[output(unit = "rad", frame = "robot")]
            fn angle(&self) -> Angle {}
            /// Turns.
            #[modulation]
            fn turn(&mut self, side: Side) {}
        }
    };
    let world = quote!(impl Room { /** Pushes. */ #[action] fn push(&mut self, side: Side) {} });
    let tunable = quote!(struct Robot { root: Player, cycle_hz: 100, budget_ms: 5, tunable, components: [Player] });
    let codes = [
        component::run(quote!(hz = 30), &operator),
        component::run(quote!(), &quote!(impl Head { fn step(&mut self, body: Body) {} })),
        tree::run(forward(), (1, 1)),
        tree::run(tunable, (1, 1)),
        tree::run(
            quote!(
                struct Robot {
                    root: Player,
                }
            ),
            (1, 1),
        ),
        params::params(params.to_string().replace("Own", "i32").parse().expect("tokens")),
        params::params(quote!(
            struct P {
                gain: Own,
            }
        )),
        params::choice(quote!(
            enum M {
                A,
                B,
            }
        )),
        params::choice(quote!(
            enum M {
                A(Own),
            }
        )),
        actions::run(quote!(), &world),
        plain_item::component_doc(quote!(
            /** Docs. */
            struct Head;
        )),
    ];
    // The machine above has a `bool` of its own.
    let of_machine = bare(component::run(quote!(), &machine()));
    assert_eq!(of_machine, ["- > bool", "- > bool"]);
    for code in codes {
        assert_eq!(bare(code), [""; 0]);
    }
}

#[test]
fn a_block_with_mistakes_is_kept_and_gets_a_stub() {
    let broken = quote!(impl Head { async fn step(&mut self, body: Body, neck: &mut Neck) {} });
    let code = component::run(quote!(hz = fast), &broken);
    assert_eq!(messages(code.clone()).len(), 3);
    let words = words(code);
    for word in ["Component", "MemberOf", "IS_STUB", "async"] {
        assert!(words.contains(&word.to_owned()), "{word}");
    }
}

#[test]
fn an_item_that_is_no_block_is_emitted_unchanged() {
    let item = quote!(
        fn head() {}
    );
    let code = component::run(quote!(), &item);
    assert!(code.to_string().starts_with(&item.to_string()));
    assert_eq!(messages(code).len(), 1);
}

#[test]
fn all_mistakes_of_a_tree_are_reported_at_once() {
    let code =
        tree::run(quote!(struct Robot { rot: Head, cycle_hz: 0, budget_ms: -1, components: [Head, Head] }), (1, 1));
    assert_eq!(messages(code).len(), 4);
}

#[test]
fn a_tree_with_mistakes_gets_a_stub_and_no_check() {
    let code = tree::run(
        quote!(
            struct Robot {
                root: Head,
                cycle_hz: often,
                components: [Head],
            }
        ),
        (1, 1),
    );
    let words = words(code);
    for word in ["Robot", "Layout", "Has"] {
        assert!(words.contains(&word.to_owned()), "{word}");
    }
    assert!(!words.contains(&"check_complete".to_owned()), "nothing is known of its graph");
}

#[test]
fn empty_input_is_an_error_and_no_panic() {
    for code in [
        component::run(quote!(), &quote!()),
        tree::run(quote!(), (1, 1)),
        tree::run(
            quote!(
                struct Robot {}
            ),
            (1, 1),
        ),
    ] {
        assert!(!messages(code).is_empty());
    }
}

#[test]
fn syntax_error_in_a_body_is_passed_on() {
    let code = component::run(quote!(), &quote!(impl Head { fn step(&mut self, neck: &Neck) { let x = ; } }));
    assert!(messages(code.clone()).is_empty());
    let words = words(code);
    assert!(words.windows(3).any(|three| three == ["x", "=", ";"]));
    assert!(words.contains(&"pass".to_owned()) && !words.contains(&"IS_STUB".to_owned()));
}

#[test]
fn syntax_error_in_a_signature_makes_a_stub() {
    let code = component::run(quote!(), &quote!(impl Head { #[state(initial)] fn up(&mut self, neck &Neck) {} }));
    assert!(messages(code.clone()).is_empty());
    let words = words(code);
    assert!(words.contains(&"IS_STUB".to_owned()) && !words.contains(&"initial".to_owned()));
}

#[test]
fn mistakes_in_actions_are_reported() {
    let world = |argument: TokenStream| {
        quote! {
            impl Room {
                /// Pushes the robot.
                #[action]
                fn push(&mut self, #argument speed: f32) {}
            }
        }
    };
    let expanded = |item: TokenStream| actions::run(TokenStream::new(), &item);
    assert_eq!(messages(expanded(world(quote!(#[range(0.0..=1.0)] #[place("field.heading")])))), [""; 0]);
    let mistakes = [
        (
            quote!(
                struct Room;
            ),
            "`#[world_actions]` belongs on an impl block",
        ),
        (quote!(impl Room { #[action] fn push(&mut self) {} }), "`push` has `#[action]` but no doc comment"),
        (quote!(impl Room { #[doc = "Pushes."] #[action(moves)] fn push(&mut self) {} }), "write `#[action]`, or"),
        (world(quote!(#[range(0.0..=1.0)] #[place("heading")])), "a place is a coordinate in a frame"),
        (world(quote!(#[plaec("field.x")])), "did you mean `#[place]`?"),
    ];
    for (item, message) in mistakes {
        let expanded = expanded(item);
        assert!(words(expanded.clone()).contains(&"Room".to_owned()));
        let [found] = &messages(expanded)[..] else { panic!("one message for `{message}`") };
        assert!(found.contains(message), "{found}");
    }
}
