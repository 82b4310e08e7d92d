"""What students who choose a certain wrong answer often think: the tags of wrong answers.

Our own words for beliefs that are well known from the classroom. A tag is no diagnosis: it is named
to a teacher only where it was chosen in two items or more.
"""

from __future__ import annotations

from sim.scene.said import template

FIRST_LAW = {
    "motion-needs-force": template("A thing moves only while a force pushes it along."),
    "force-carried-along": template("A push is carried along by the thing and is used up."),
    "speed-follows-force": template("The speed follows the force: half the force, half the speed."),
    "rest-is-natural": template("Everything comes to rest by itself; rest needs no explanation."),
    "slow-things-stop": template("What is very slow is nearly at rest and stops soon."),
    "heavy-keeps-going": template("A heavy thing keeps going longer because it is heavy."),
    "heavy-stops-sooner": template("A heavy thing stops sooner because it is heavy."),
    "negative-means-slowing": template("A negative velocity means that the thing slows down."),
    "zero-resultant-means-rest": template(
        "Where the resultant force is zero the thing is at rest."
    ),
    "rest-means-no-forces": template("On a thing at rest no forces act at all."),
    "motion-depends-on-camera": template(
        "Who moves along sees other forces than who stands still."
    ),
}
THIRD_LAW = {
    "bigger-pushes-more": template("The heavier or larger one of the two pushes harder."),
    "own-mass-own-force": template("The force on a thing goes with its own mass."),
    "mover-pushes-more": template("The one that moves or acts pushes harder."),
    "stiffer-pushes-more": template("The harder or springier one of the two pushes harder."),
    "passive-cannot-push": template(
        "A wall, a floor or a table cannot push: it is only in the way."
    ),
    "reaction-comes-later": template(
        "The second force of the pair answers the first one a little later."
    ),
    "equal-forces-cancel": template(
        "Two equal and opposite forces cancel, so nothing can start to move."
    ),
    "winner-overcomes": template("The one that wins pushed harder than the one that gave way."),
    "damage-shows-force": template("The one that is damaged more was pushed harder."),
    "no-touch-no-pair": template("Without touching there is only one force, not a pair."),
    "no-motion-no-force": template("While nothing moves there are no forces."),
    "weight-is-passed-on": template("The weight of a thing is passed on to what it lies on."),
    "force-passed-on": template(
        "What lies between two things only passes a force on from one to the other."
    ),
    "partner-is-balance": template("The partner of a force is the other force on the same thing."),
}
SECOND_LAW = {
    "mass-has-no-say": template("The same force gives every mass the same change of velocity."),
    "mass-counts-directly": template("More mass means more change of motion."),
    "strongest-force-wins": template("Only the largest force counts; the others do nothing."),
    "forces-always-add": template("Forces add up, whatever their directions."),
    "force-must-beat-weight": template("A small force moves nothing, or only keeps the speed."),
    "time-has-no-say": template("How long a force acts does not matter."),
}
MOMENTUM = {
    "momentum-has-no-sign": template("Momentum is a size without a direction."),
    "momentum-is-speed": template("Momentum is another word for speed."),
    "momentum-is-energy": template("Momentum and kinetic energy are the same thing."),
    "energy-disappears": template("Energy that the motion has no longer is gone for good."),
    "stop-needs-more-than-bounce": template("Stopping takes a larger change than bouncing back."),
}
BELIEFS: dict[str, str] = FIRST_LAW | THIRD_LAW | SECOND_LAW | MOMENTUM
