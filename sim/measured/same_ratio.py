"""Whether the model may be believed beside the velocities just before and after the contact."""

from __future__ import annotations

import math

from sim.measured.events.quantities import mass_ratio
from sim.measured.events.story import Story
from sim.measured.model.fit import Fit
from sim.measured.model.quantity import Untold
from sim.measured.model.unknowns import Effect

AS_WELL = 1.02
"""Times the scatter beside the contact: a model that leaves so little of all is as good."""


def two_sensors(story: Story) -> bool:
    """Whether each cart has a sensor of its own, even where both count on one axis."""
    return story.measured.own or (story.frames is not None and story.frames.joined)


def same_ratio(story: Story, made: Fit, wanted: Effect | None) -> bool:
    """Whether the model's mass ratio lies in the interval of the velocities; else white residuals
    deceive, unless the lines beside the contact leave as much as the model leaves of all readings:
    then they may be wrong as well (`_doubted`). An effect that the reader asks for is theirs."""
    if two_sensors(story):
        return False  # one model of both places cannot know that they have two scales, two clocks
    if wanted is not None or not (story.outcome and story.speeds and story.step):
        return True
    if made.noise <= AS_WELL * story.speeds.scatter:
        return True
    ratio = mass_ratio(story.speeds, story.step, story.outcome, story.measured.names)
    if isinstance(ratio, Untold):
        return True
    half = made.factor * made.sd("ln_ratio")
    low, high = math.log(ratio.low) - half, math.log(ratio.high) + half
    return low <= math.log(made.parameters.ratio) <= high
