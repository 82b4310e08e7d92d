"""What friction in the contact may take: counted while it can be, and said where it cannot."""

from __future__ import annotations

import pytest

from sim.measured.events.quantities import NOT_IN_STEP, WIDEST_RATIO, with_loss
from sim.measured.model.believable import TOO_WIDE
from sim.measured.model.quantity import Known, Untold

RATIO = Known("mass_ratio", "mass of B ÷ mass of A", 2.0, 1.9, 2.0 * 2.0 / 1.9, 0.05, "")
OPEN = Known("mass_ratio", "mass of B ÷ mass of A", 2.0, 1.1, 2.0 * 2.0 / 1.1, 0.4, "")


@pytest.mark.parametrize("share", [0.0, 0.018, 0.1, 0.2])
def test_a_small_share_widens_the_interval_and_never_beyond_the_widest(share: float) -> None:
    told = with_loss(RATIO, share)
    assert isinstance(told, Known) and told.alone == (RATIO.low, RATIO.high)
    assert told.high - told.low >= (RATIO.high - RATIO.low) * (1.0 - 1e-9)
    assert told.high / told.value - 1.0 < WIDEST_RATIO


@pytest.mark.parametrize("share", [0.21, 1.0, 47.257])
def test_a_share_that_no_friction_takes_means_that_the_carts_are_not_in_step(share: float) -> None:
    told = with_loss(RATIO, share)
    assert isinstance(told, Untold) and told.reason == NOT_IN_STEP


def test_a_ratio_that_is_too_wide_is_not_told() -> None:
    told = with_loss(OPEN, 0.018)
    assert isinstance(told, Untold) and told.reason == TOO_WIDE
