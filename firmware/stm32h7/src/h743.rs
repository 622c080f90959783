//! The chip as its reset leaves it: 64 MHz, the link on USART3 (PD8 sends, PD9 hears).

use cortex_m::peripheral::{DWT, SCB};
use embassy_stm32::usart::{BufferedInterruptHandler, BufferedUart, BufferedUartRx, BufferedUartTx, Config};
use embassy_stm32::{bind_interrupts, pac, peripherals};
use static_cell::ConstStaticCell;

use crate::board::Board;

bind_interrupts!(struct Interrupts {
    USART3 => BufferedInterruptHandler<peripherals::USART3>;
});

const BAUD: u32 = 921_600;

static HEARD: ConstStaticCell<[u8; 2048]> = ConstStaticCell::new([0; 2048]);
static SAID: ConstStaticCell<[u8; 2048]> = ConstStaticCell::new([0; 2048]);

/// The board.
pub(crate) struct H743 {
    port: BufferedUart<'static>,
}

impl H743 {
    /// Switches the board's parts on. Called once.
    pub(crate) fn start() -> Self {
        let parts = embassy_stm32::init(embassy_stm32::Config::default());
        if let Some(mut core) = cortex_m::Peripherals::take() {
            core.DCB.enable_trace();
            core.DWT.enable_cycle_counter();
        }
        let mut config = Config::default();
        config.baudrate = BAUD;
        let (said, heard) = (SAID.take(), HEARD.take());
        let port = BufferedUart::new(parts.USART3, parts.PD9, parts.PD8, said, heard, Interrupts, config);
        Self { port: port.expect("the rate fits the clock") }
    }
}

impl Board for H743 {
    type Ear = BufferedUartRx<'static>;
    type Mouth = BufferedUartTx<'static>;
    const FINE_HZ: u32 = 64_000_000;

    fn link(self) -> (Self::Ear, Self::Mouth) {
        let (mouth, ear) = self.port.split();
        (ear, mouth)
    }

    fn fine() -> u32 {
        DWT::cycle_count()
    }

    fn cry(bytes: &[u8]) {
        for &byte in bytes {
            while !pac::USART3.isr().read().txe() {}
            pac::USART3.tdr().write(|word| word.set_dr(byte.into()));
        }
        while !pac::USART3.isr().read().tc() {}
    }

    fn reset() -> ! {
        SCB::sys_reset()
    }
}
