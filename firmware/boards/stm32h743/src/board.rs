//! The chip with the clock configuration after reset: 64 MHz. The link is USART3: PD8 transmits, PD9 receives.

use bica_firmware::Board;
use cortex_m::peripheral::{DWT, SCB};
use embassy_stm32::usart::{BufferedInterruptHandler, BufferedUart, BufferedUartRx, BufferedUartTx, Config};
use embassy_stm32::{bind_interrupts, pac, peripherals};
use static_cell::ConstStaticCell;

bind_interrupts!(struct Interrupts {
    USART3 => BufferedInterruptHandler<peripherals::USART3>;
});

const BAUD: u32 = 921_600;
/// Size of each buffer of the serial port, bytes.
const BUFFER_BYTES: usize = 2048;

static RX_BUFFER: ConstStaticCell<[u8; BUFFER_BYTES]> = ConstStaticCell::new([0; BUFFER_BYTES]);
static TX_BUFFER: ConstStaticCell<[u8; BUFFER_BYTES]> = ConstStaticCell::new([0; BUFFER_BYTES]);

/// The board.
pub(crate) struct Stm32h743 {
    uart: BufferedUart<'static>,
}

impl Stm32h743 {
    /// Starts the board's peripherals. Called once.
    pub(crate) fn start() -> Self {
        let parts = embassy_stm32::init(embassy_stm32::Config::default());
        if let Some(mut core) = cortex_m::Peripherals::take() {
            core.DCB.enable_trace();
            core.DWT.enable_cycle_counter();
        }
        let mut config = Config::default();
        config.baudrate = BAUD;
        let (tx, rx) = (TX_BUFFER.take(), RX_BUFFER.take());
        let uart = BufferedUart::new(parts.USART3, parts.PD9, parts.PD8, tx, rx, Interrupts, config);
        Self { uart: uart.expect("the clock supports the baud rate") }
    }
}

impl Board for Stm32h743 {
    type Rx = BufferedUartRx<'static>;
    type Tx = BufferedUartTx<'static>;
    const COUNTER_HZ: u32 = 64_000_000;

    fn link(self) -> (Self::Rx, Self::Tx) {
        let (tx, rx) = self.uart.split();
        (rx, tx)
    }

    fn counter() -> u32 {
        DWT::cycle_count()
    }

    fn write_blocking(bytes: &[u8]) {
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
