/**
 * Other engines on the scenes of `_peers_scenes.py`: boxes on a line, no gravity, friction, damping
 * or rotation, everything else as each engine has it when nothing is set.
 *
 *     node tests/benchmarks/_peers.mjs < scenes.json > results.json
 *
 * SI in and out. Each engine has `build(scene)`, which returns `step()` and `state()`.
 */

import { readFileSync } from "node:fs";
import RAPIER from "@dimforge/rapier2d-compat";
import Matter from "matter-js";
import * as p2 from "p2-es";
import { Box, Vec2, World } from "planck";

const [HEIGHT, WALL] = [0.1, 1]; // m
const PX = 100; // pixels per metre for matter-js, which counts in pixels
const LONG_ENOUGH = 0.2; // s to measure

await RAPIER.init();

/** Centres of the walls' boxes. */
const walls = ({ left, right }) => [
  ...(left === null ? [] : [left - WALL / 2]),
  ...(right === null ? [] : [right + WALL / 2]),
];

const ENGINES = {
  "matter-js": (scene) => {
    const engine = Matter.Engine.create();
    engine.gravity.scale = 0;
    const smooth = { friction: 0, frictionAir: 0, frictionStatic: 0, restitution: scene.e };
    const carts = scene.carts.map(({ mass, x, v, length }) => {
      const options = { ...smooth, inertia: Number.POSITIVE_INFINITY };
      const body = Matter.Bodies.rectangle(x * PX, 0, length * PX, HEIGHT * PX, options);
      Matter.Body.setMass(body, mass);
      Matter.Body.setInertia(body, Number.POSITIVE_INFINITY);
      Matter.Body.setVelocity(body, { x: (v * PX) / 60, y: 0 });
      return body;
    });
    const still = walls(scene).map((x) => {
      const options = { ...smooth, isStatic: true };
      return Matter.Bodies.rectangle(x * PX, 0, WALL * PX, HEIGHT * PX, options);
    });
    Matter.Composite.add(engine.world, [...carts, ...still]);
    return {
      step: () => Matter.Engine.update(engine, 1000 * scene.dt),
      state: () =>
        carts.map((b) => [b.position.x / PX, (Matter.Body.getVelocity(b).x * 60) / PX]),
    };
  },

  planck: (scene) => {
    const world = new World({ gravity: new Vec2(0, 0) });
    const made = (type, x, v, length, density) => {
      const body = world.createBody({
        type,
        position: new Vec2(x, 0),
        linearVelocity: new Vec2(v, 0),
        fixedRotation: true,
      });
      const shape = new Box(length / 2, HEIGHT / 2);
      body.createFixture({ shape, density, friction: 0, restitution: scene.e });
      return body;
    };
    const carts = scene.carts.map(({ mass, x, v, length }) =>
      made("dynamic", x, v, length, mass / (length * HEIGHT)),
    );
    for (const x of walls(scene)) made("static", x, 0, WALL, 0);
    return {
      step: () => world.step(scene.dt),
      state: () => carts.map((b) => [b.getPosition().x, b.getLinearVelocity().x]),
    };
  },

  rapier2d: (scene) => {
    const world = new RAPIER.World({ x: 0, y: 0 });
    world.timestep = scene.dt;
    const box = (length) =>
      RAPIER.ColliderDesc.cuboid(length / 2, HEIGHT / 2).setRestitution(scene.e).setFriction(0);
    const carts = scene.carts.map(({ mass, x, v, length }) => {
      const desc = RAPIER.RigidBodyDesc.dynamic().setTranslation(x, 0).setLinvel(v, 0);
      const body = world.createRigidBody(desc.lockRotations());
      world.createCollider(box(length).setMass(mass), body);
      return body;
    });
    for (const x of walls(scene)) {
      const body = world.createRigidBody(RAPIER.RigidBodyDesc.fixed().setTranslation(x, 0));
      world.createCollider(box(WALL), body);
    }
    return {
      step: () => world.step(),
      state: () => carts.map((b) => [b.translation().x, b.linvel().x]),
      free: () => world.free(),
    };
  },

  "p2-es": (scene) => {
    const world = new p2.World({ gravity: [0, 0] });
    world.defaultContactMaterial.restitution = scene.e;
    world.defaultContactMaterial.friction = 0;
    const made = (mass, x, v, length) => {
      const body = new p2.Body({ mass, position: [x, 0], velocity: [v, 0], fixedRotation: true });
      body.damping = 0;
      body.addShape(new p2.Box({ width: length, height: HEIGHT }));
      world.addBody(body);
      return body;
    };
    const carts = scene.carts.map(({ mass, x, v, length }) => made(mass, x, v, length));
    for (const x of walls(scene)) made(0, x, 0, WALL);
    return {
      step: () => world.step(scene.dt),
      state: () => carts.map((b) => [b.position[0], b.velocity[0]]),
    };
  },
};

/** The end state after all steps. */
function finished(build, scene) {
  const run = build(scene);
  const count = Math.round(scene.until / scene.dt);
  for (let k = 0; k < count; k += 1) run.step();
  const state = run.state();
  run.free?.();
  return state;
}

/** Seconds of all steps of one run, the world's making left out; the best of several. */
function timed(build, scene) {
  const count = Math.round(scene.until / scene.dt);
  let [best, spent] = [Number.POSITIVE_INFINITY, 0];
  while (spent < LONG_ENOUGH) {
    const run = build(scene);
    const start = performance.now();
    for (let k = 0; k < count; k += 1) {
      run.step();
      run.state();
    }
    const seconds = (performance.now() - start) / 1000;
    run.free?.();
    best = Math.min(best, seconds);
    spent += seconds;
  }
  return best;
}

const scenes = JSON.parse(readFileSync(0, "utf8"));
const results = Object.entries(ENGINES).map(([engine, build]) => ({
  engine,
  ends: Object.fromEntries(
    scenes.map((scene) => [scene.name, scene.phases.map((one) => finished(build, one))]),
  ),
  seconds: Object.fromEntries(scenes.map((s) => [s.name, timed(build, s.phases[0])])),
}));
process.stdout.write(JSON.stringify(results));
