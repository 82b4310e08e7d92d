"""The page's worker: a package that comes later, and what is under way when it does."""

from __future__ import annotations

from typing import Any

from tests.web.scene.given.widget_site import in_node

# A stand-in for Python: answers when told to; knows with which packages it was started.
SCRIPT = """
const { Client } = await import(`${source}/runtime/client.js`);
const started = [];
const failure = (reason) => Object.assign(new Error(reason), { reason });
const start = async (more) => {
  if (more.includes("missing")) throw failure("not-packed");
  const runtime = { more: [...more], asked: [], stopped: false, onlost: () => {} };
  runtime.request = (message) => new Promise((resolve, reject) => {
    runtime.asked.push({ message, resolve, reject });
  });
  runtime.stop = () => {
    runtime.stopped = true;
    for (const { reject } of runtime.asked) reject(failure("stopped"));
  };
  started.push(runtime);
  return runtime;
};
const turn = () => new Promise((resolve) => setTimeout(resolve));
const client = new Client(start);
const answer = (runtime) => {
  const { message, resolve } = runtime.asked.pop();
  resolve({ header: { ok: true, by: runtime.more, kind: message.kind }, numbers: [] });
};
const said = [];
"""


def told(script: str) -> Any:
    return in_node(SCRIPT + script + "give(said);", {})


def test_a_request_under_way_is_answered_by_the_python_that_takes_over() -> None:
    said = told(
        """
        const asked = client.ask({}, () => ({ kind: "run" }));
        await turn();
        await client.need(["numpy"]);
        await turn();
        said.push(started.length, started[0].stopped, started[1].asked.length);
        answer(started[1]);
        said.push((await asked).header.by, client.state);
        """
    )
    assert said == [2, True, 1, ["numpy"], "ready"]


def test_a_package_is_started_once_for_all_who_need_it() -> None:
    said = told(
        """
        await Promise.all([client.need(["numpy"]), client.need(["numpy"])]);
        await client.need(["numpy"]);
        said.push(started.map(({ more }) => more));
        await client.need(["numpy", "scipy"]);
        said.push(started.at(-1).more);
        """
    )
    assert said == [[[], ["numpy"]], ["numpy", "scipy"]]


def test_a_package_that_is_not_there_leaves_python_as_it_is() -> None:
    said = told(
        """
        await client.need(["missing"]).catch((error) => said.push(error.reason));
        const asked = client.ask({}, () => ({ kind: "run" }));
        await turn();
        answer(started[0]);
        said.push((await asked).header.ok, client.state);
        await client.need(["missing"]).catch((error) => said.push(error.reason));
        await client.need(["numpy"]);
        said.push(started.at(-1).more);
        """
    )
    assert said == ["not-packed", True, "ready", "not-packed", ["numpy"]]


def test_a_python_that_is_lost_comes_back_with_its_packages() -> None:
    said = told(
        """
        await client.need(["numpy"]);
        const asked = client.ask({}, () => ({ kind: "map" }));
        await turn();
        started[1].onlost(new Error("gone"));
        await turn();
        said.push(started.length, started[2].more);
        answer(started[2]);
        said.push((await asked).header.kind);
        """
    )
    assert said == [3, ["numpy"], "map"]


# Starts that come when the test says so: the one with packages and the one after a loss cross.
CROSSING = """
        let wait = false;
        const held = [];
        const slow = new Client(async (more) => {
          if (wait) await new Promise((resolve, reject) => held.push({ resolve, reject }));
          return start(more);
        });
        slow.wake();
        await turn();
        wait = true;
        const grown = slow.need(["numpy"]);
        await turn();
        started[0].onlost(new Error("gone"));
        await turn();
        held[0].resolve();
        await grown;
"""


def test_a_python_that_comes_after_one_with_more_packages_takes_nothing_over() -> None:
    said = told(
        CROSSING
        + """
        held[1].resolve();
        await turn();
        await slow.need(["numpy"]);
        const asked = slow.ask({}, () => ({ kind: "map" }));
        await turn();
        said.push(started.map(({ more, stopped, asked }) => [more, stopped, asked.length]));
        answer(started[1]);
        said.push((await asked).header.by, slow.state);
        """
    )
    assert said == [[[[], True, 0], [["numpy"], False, 1], [[], True, 0]], ["numpy"], "ready"]


def test_a_late_start_that_fails_leaves_the_python_that_answers() -> None:
    said = told(
        CROSSING
        + """
        held[1].reject(failure("stalled"));
        await turn();
        const asked = slow.ask({}, () => ({ kind: "map" }));
        await turn();
        answer(started[1]);
        said.push((await asked).header.by, slow.state);
        """
    )
    assert said == [["numpy"], "ready"]


def test_a_python_that_is_lost_twice_comes_back_with_the_packages_it_had() -> None:
    said = told(
        CROSSING
        + """
        started[1].onlost(new Error("gone"));
        held[1].resolve();
        await turn();
        held[2].resolve();
        const asked = slow.ask({}, () => ({ kind: "map" }));
        await turn();
        answer(started[3]);
        said.push(started.map(({ more, stopped }) => [more, stopped]));
        said.push((await asked).header.by, slow.state);
        """
    )
    pythons = [[[], True], [["numpy"], True], [[], True], [["numpy"], False]]
    assert said == [pythons, ["numpy"], "ready"]


def test_the_client_keeps_the_newest_request_and_survives_three_deaths() -> None:
    log = in_node(
        """const { Client } = await import(source + "/runtime/client.js");
        const log = [];
        let runtimes = 0;
        const start = async () => {
          runtimes += 1;
          const mine = runtimes;
          const runtime = { onlost: () => {}, stop: () => {}, request: (message) => {
            log.push(`${mine}:${message.set}`);
            if (message.set === "kill") { setTimeout(() => runtime.onlost("gone"), 1);
              return new Promise(() => {}); }
            return new Promise((resolve) => setTimeout(() => resolve({ header: { ok: true },
              numbers: new Float64Array(0) }), 2));
          } };
          return runtime;
        };
        const client = new Client(start);
        const [a, b] = [{}, {}];
        const ask = (owner, set) => client.ask(owner, () => ({ set }));
        const answers = await Promise.all([ask(a, 1), ask(a, 2), ask(a, 3), ask(b, 9)]);
        log.push(answers.map((answer) => answer.sent.set).join());
        const error = await ask(a, "kill").catch((reason) => reason);
        log.push(`${error.message} ${client.state} ${runtimes}`);
        give(log);""",
        None,
    )
    assert log == ["1:3", "1:9", "3,3,3,9", *[f"{k}:kill" for k in (1, 2, 3, 4)], "gone failed 4"]


def test_a_request_that_is_refused_takes_nothing_from_the_one_that_waits_behind_it() -> None:
    said = told(
        """
        const refused = client.need(["missing"]).catch((error) => said.push(error.reason));
        await client.need(["numpy"]);
        await refused;
        said.push(started.at(-1).more);
        """
    )
    assert said == ["not-packed", ["numpy"]]


def test_packages_that_are_there_stay_there_after_another_was_refused() -> None:
    said = told(
        """
        await client.need(["numpy"]);
        await client.need(["missing"]).catch((error) => said.push(error.reason));
        await client.need(["numpy"]);
        said.push(started.length);
        """
    )
    assert said == ["not-packed", 2]


def test_what_cannot_be_computed_is_no_failure_of_python() -> None:
    said = told(
        """
        const asked = client.ask({}, () => ({ kind: "run" })).catch(({ reason }) => reason);
        await turn();
        await turn();
        started[0].asked.pop().reject(failure("request-failed"));
        said.push(await asked, client.state, started.length);
        """
    )
    assert said == ["request-failed", "ready", 1]
