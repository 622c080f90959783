//! Limit of nesting: whether a text is read or refused, and never a full stack.

use bica_vicode::read;

/// Beginnings of texts, each of which nests one level deeper.
const TOWERS: [&str; 14] =
    ["(", "!", "&", "A<", "if a {} else ", "|x| ", "a = ", "-", "[", "{", "m!(", "a + ", "a.b()", "impl A { fn f() {"];

fn is_too_deep(text: &str) -> bool {
    read(text).problems.iter().any(|problem| problem.message.contains("nested too deeply"))
}

#[test]
fn only_towers_are_too_deep() {
    let long = "fn f() { g(1, -2, &&x); if a { b() } else if c { d() } }\n".repeat(1000);
    assert!(!is_too_deep(&long));
    for tower in TOWERS {
        assert!(!is_too_deep(&tower.repeat(20)), "{tower}");
        assert!(is_too_deep(&tower.repeat(10_000)), "{tower}");
    }
}

#[test]
fn deepest_text_is_read_in_the_stack_of_a_thread() {
    for tower in TOWERS {
        let counts: Vec<usize> = (0..3000).collect();
        let end = counts.partition_point(|count| !is_too_deep(&format!("fn f() {{ {}", tower.repeat(*count))));
        let deepest = format!("fn f() {{ {}", tower.repeat(end - 1));
        for text in [deepest.clone(), format!("{deepest} x"), deepest.replace("fn f() {", "type A = ")] {
            assert!(!read(&text).problems.is_empty(), "{text}");
        }
    }
}

#[test]
fn unmatched_closing_brackets_do_not_panic() {
    assert!(!is_too_deep(")}]};,)(};"));
}
