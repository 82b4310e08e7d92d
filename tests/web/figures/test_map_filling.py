"""A map that is being filled goes on when the next one is refused, and ends when it is not."""

from __future__ import annotations

from tests.web.scene.given.widget_site import in_node

SCRIPT = """
const { Filling } = await import(`${source}/map/filling.js`);
const waiting = [];
const asked = [];
const told = [];
const filling = new Filling(
  ({ mass }, from) => {
    asked.push([mass, from]);
    return new Promise((resolve) => waiting.push(() => {
      const ok = mass > 0;
      resolve({ header: { ok, problems: [], done: from + 1, runs: 3 }, numbers: [mass, from] });
    }));
  },
  {
    slice: (numbers) => told.push(numbers),
    progress: (done) => told.push(done),
    complete: ({ mass }) => told.push(`all of ${mass}`),
    failed: (error) => told.push(error.message),
  },
);
const turn = () => new Promise((done) => setTimeout(done, 1));
const answer = async () => {
  await turn();
  waiting.shift()();
  await turn();
};
let refused = false;
const map = (mass) => filling.map({ mass }, async () => told.push(`drawn ${mass}`)).catch(() => {
  refused = true;
});
void map(1);
await answer(); // the first slice
void map(data);
let complete = false;
void filling.whole.then(() => (complete = true));
await answer(); // a slice of the first map: too late, or to be run again
await answer(); // the next map's first
const early = complete;
while (waiting.length) await answer();
await turn();
give({ told, asked, refused, early, complete });
"""


def test_after_a_refused_map_the_one_that_is_shown_is_filled() -> None:
    said = in_node(SCRIPT, -1)
    assert said["refused"]
    assert said["told"] == ["drawn 1", 1, 1, [1, 1], 2, [1, 2], "all of 1"]
    assert (said["early"], said["complete"]) == (False, True)


def test_a_newer_map_takes_its_place_and_what_waits_for_all_waits_for_it() -> None:
    said = in_node(SCRIPT, 2)
    assert not said["refused"]
    assert said["told"] == ["drawn 1", 1, "drawn 2", 1, [2, 1], 2, [2, 2], "all of 2"]
    assert said["asked"] == [[1, 0], [1, 1], [2, 0], [2, 1], [2, 2]]
    assert (said["early"], said["complete"]) == (False, True)
