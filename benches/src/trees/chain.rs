//! Chains: each component requires the next and does `v = v * 31 + 1`.

mod ten {
    use bica::prelude::*;
    nine!(chain!(Ten, every: A0));
}

mod rarely {
    use bica::prelude::*;
    nine!(chain!(Rarely, rarely: A0));
}

mod hundred {
    use bica::prelude::*;
    macro_rules! rest {
        ($($names:ident)*) => { ninety!(chain!(Hundred, every: $($names)*)); };
    }
    nine!(rest!(A0));
}

pub use hundred::Hundred;
pub use rarely::Rarely;
pub use ten::Ten;
