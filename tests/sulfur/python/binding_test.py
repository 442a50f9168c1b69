"""The binding for Python: every call once, and what it makes of errors."""
import gc
import math
import re
import sys
import unittest
import weakref

import sulfur
from sulfur import c


def crate_on_floor():
    world = sulfur.World()
    world.add(sulfur.floor((-20, 0), (20, 0)))
    return world, world.add(sulfur.box(mass=2), position=(0, 0.6))


class Bodies(unittest.TestCase):
    def setUp(self):
        self.world = sulfur.World(gravity=(0, 0))
        plan = sulfur.box(mass=2, material={"restitution": 0.25})
        plan.name = "crate"
        plan.wear("crate.png", [(0, 1)] * 5, [(0, 1, 2), (1, 2, 3)])
        self.crate = self.world.add(plan, position=(1, 2), angle=0.5)

    def test_are_what_their_blueprints_say(self):
        crate = self.crate
        self.assertEqual(crate.name, "crate")
        self.assertEqual(crate.kind, sulfur.DYNAMIC)
        self.assertAlmostEqual(crate.mass, 2, 5)
        self.assertAlmostEqual(crate.inertia, 1 / 3, 5)
        self.assertEqual(crate.material.restitution, 0.25)
        self.assertEqual(crate.skin, ("crate.png", [(0, 1)] * 5, [(0, 1, 2), (1, 2, 3)]))
        self.assertEqual(len(crate.particles), 5)
        self.assertTrue(crate.exists)
        self.assertEqual(self.world.bodies, [crate])
        ball = self.world.add(sulfur.ball())
        self.assertIsNone(ball.skin)
        self.assertNotEqual(ball, crate)
        ball.remove()
        self.assertFalse(ball.exists)

    def test_move(self):
        crate = self.crate
        self.assertAlmostEqual(crate.angle, 0.5, 6)
        crate.velocity = (3, 4)
        self.assertEqual(tuple(crate.velocity), (3, 4))
        crate.set_motion((1, 0), 2)
        self.assertAlmostEqual(crate.angular_velocity, 2, 4)
        self.world.step()
        self.assertAlmostEqual(crate.position.x, 1.002, 6)
        self.assertAlmostEqual(crate.interpolated_pose(0).position.x, 1, 6)
        crate.pose = ((0, 0), 0)
        self.assertAlmostEqual(crate.bounds.high.x, 0.5, 5)
        crate.set_motion((0, 0), 0)
        crate.apply_impulse((2, 0), crate.centre_of_mass)
        crate.apply_angular_impulse(1)
        self.assertAlmostEqual(crate.velocity.x, 1, 5)
        self.assertAlmostEqual(crate.angular_velocity, 3, 4)
        crate.apply_force((0, 100), crate.centre_of_mass)
        crate.apply_torque(-9)
        self.world.step()
        self.assertGreater(crate.velocity.y, 0)
        self.assertLess(crate.angular_velocity, 3)

    def test_change(self):
        crate = self.crate
        crate.material = sulfur.material(static_friction=2)
        crate.filter = sulfur.collision_filter(group=-1)
        crate.gravity_scale, crate.user_data, crate.self_collision = 0.5, 2**63, True
        self.assertEqual(crate.material.static_friction, 2)
        self.assertEqual(crate.filter.group, -1)
        self.assertEqual((crate.gravity_scale, crate.user_data, crate.self_collision),
                         (0.5, 2**63, True))
        crate.sensor = True
        self.world.add(sulfur.ball(), position=(1, 2))
        self.world.step()
        self.assertEqual(len(crate.visitors), 1)
        self.assertEqual(len(self.world.events["sensors_entered"]), 1)
        crate.wake()
        self.assertFalse(crate.asleep)

    def test_come_to_rest(self):
        crate = self.crate
        self.assertFalse(crate.fixed_rotation)
        crate.fixed_rotation = True
        crate.set_motion((1, 0), 2)
        self.world.step()
        self.assertTrue(crate.fixed_rotation)
        self.assertAlmostEqual(crate.angular_velocity, 0, 5)
        crate.set_damping(50, 100)
        self.assertEqual((crate.linear_damping, crate.angular_damping), (50, 100))
        self.world.step()
        self.assertAlmostEqual(crate.velocity.x, 0.95 / 1.05, 4)
        crate.sleeping_allowed = False
        self.assertFalse(crate.sleeping_allowed or crate.put_to_sleep())
        crate.sleeping_allowed = True
        self.assertTrue(crate.put_to_sleep() and crate.asleep)

    def test_take_part(self):
        crate = self.crate
        crate.set_motion((1, 0), 0)
        self.assertTrue(crate.enabled)
        crate.enabled = False
        before = crate.centre_of_mass.x
        self.world.step()
        self.assertFalse(crate.enabled)
        self.assertEqual(crate.centre_of_mass.x, before)
        crate.enabled = True
        self.world.step()
        self.assertGreater(crate.centre_of_mass.x, before)
        crate.kind = sulfur.FIXED
        self.assertEqual(crate.kind, sulfur.FIXED)
        self.assertEqual(crate.velocity.x, 0)
        self.assertEqual(crate.contacts, [])
        self.assertFalse(crate.touches(crate))

    def test_frames(self):
        crate = self.crate
        place = crate.to_world((1, 2))
        back = crate.from_world(place)
        self.assertAlmostEqual(back.x, 1, 9)
        self.assertAlmostEqual(back.y, 2, 9)
        turned = crate.vector_from_world(crate.vector_to_world((3, 4)))
        self.assertAlmostEqual(turned.x, 3, 5)
        self.assertAlmostEqual(turned.y, 4, 5)

    def test_pass_through_each_other(self):
        ball = self.world.add(sulfur.ball())
        self.world.set_collision(ball, self.crate, False)
        self.assertFalse(self.world.collision(ball, self.crate))
        self.assertEqual(self.world.vetoes, [(self.crate, ball)])

    def test_are_driven(self):
        plan = sulfur.ball()
        plan.kind = sulfur.KINEMATIC
        driven = self.world.add(plan)
        driven.move_to((0.01, 0))
        self.world.step()
        self.assertAlmostEqual(driven.position.x, 0.01, 9)


class Plans(unittest.TestCase):
    def test_are_built_by_hand(self):
        plan = sulfur.Blueprint()
        with self.assertRaises(sulfur.Error):
            plan.validate()
        a = plan.add_particle((0, 0), mass=3)
        b = plan.add_particle((2, 0), pinned=True)
        plan.add_joint(a, b, stiffness=50, rest_length=1, radius=0.125,
                       material=sulfur.material(surface_speed=2))
        plan.validate()
        self.assertEqual((plan.mass, tuple(plan.centre_of_mass)), (4, (0.5, 0)))
        joint, particle = plan.joints()[0], plan.particles()[1]
        self.assertEqual((joint.rest_length, joint.material.surface_speed), (1, 2))
        self.assertTrue(particle.pinned)
        particle.mass, joint.stiffness = 7, 60
        plan.set_particle(1, particle)
        plan.set_joint(0, joint)
        plan.sensor, plan.self_collision = True, True
        plan.filter, plan.material = sulfur.collision_filter(mask=3), sulfur.material(restitution=1)
        copy = plan.copy()
        self.assertEqual((copy.mass, copy.joints()[0].stiffness), (10, 60))
        self.assertEqual((copy.filter.mask, copy.material.restitution), (3, 1))
        self.assertTrue(copy.sensor and copy.self_collision)

    def test_have_elastic_angles(self):
        plan = sulfur.Blueprint()
        for place in ((0, 0), (1, 0), (1, 1)):
            plan.add_particle(place)
        plan.add_joint(0, 1)
        plan.add_joint(1, 2)
        self.assertEqual(plan.add_angle(0, 1, 2, stiffness=7, rest_angle=0.5), 0)
        spec = plan.angles()[0]
        self.assertEqual((spec.c, spec.stiffness, spec.rest_angle), (2, 7, 0.5))
        spec.stiffness, spec.rest_angle = 2, 0
        plan.set_angle(0, spec)
        world = sulfur.World(gravity=(0, 0))
        body = world.add(plan)
        self.assertAlmostEqual(body.angles[0].angle, math.pi / 2, 6)
        self.assertEqual(body.angles[0].info.b, body.particles[1].id)
        world.step()
        self.assertAlmostEqual(body.angles[0].torque, -math.pi, 1)
        self.assertEqual(world.statistics.explicit_angles, 1)

    def test_have_angles_with_motors(self):
        plan = sulfur.Blueprint()
        for place in ((0, 0), (1, 0), (2, 0)):
            plan.add_particle(place)
        plan.add_joint(0, 1)
        plan.add_joint(1, 2)
        plan.add_angle(0, 1, 2, upper=0.5, motor_speed=2, motor_max=50)
        world = sulfur.World(gravity=(0, 0))
        elbow, = world.add(plan).angles
        world.run(0.1)
        self.assertAlmostEqual(elbow.angle, 0.2, 2)
        world.run(0.5)
        self.assertAlmostEqual(elbow.angle, 0.5, 3)
        self.assertTrue(elbow.info.at_upper)
        elbow.change_drive(upper=1, motor_target=0.8)
        world.run(0.5)
        self.assertAlmostEqual(elbow.angle, 0.8, 3)
        elbow.remove()
        self.assertFalse(elbow.exists)

    def test_of_all_shapes_make_bodies(self):
        world = sulfur.World()
        line, triangle = [(0, 0), (3, 0), (4, 1)], [(0, 0), (1, 0), (0, 1)]
        for plan in (sulfur.ground(points=line, bends=[1, -0.5]), sulfur.floor((0, 0), (1, 0)), sulfur.box(),
                     sulfur.polygon(points=triangle), sulfur.ball(), sulfur.wheel(),
                     sulfur.rope(end=(3, 0), slack=0.5, links=10, bending=2), sulfur.chain(), sulfur.bridge(),
                     sulfur.jelly(), sulfur.cloth(), sulfur.wall(), sulfur.blob()):
            world.add(plan)
        self.assertEqual(len(world.bodies), 13)

    def test_refuse_options_that_there_are_not(self):
        with self.assertRaisesRegex(TypeError, "BoxOptions has no option weight"):
            sulfur.box(weight=3)


class Parts(unittest.TestCase):
    def setUp(self):
        self.world = sulfur.World(gravity=(0, 0))
        self.balls = [self.world.add(sulfur.ball(), position=(2 * i, 0)) for i in range(2)]
        self.a, self.b = (ball.particles[0] for ball in self.balls)

    def test_particles(self):
        self.a.mass = 4
        self.a.apply_impulse((8, 0))
        self.assertEqual(tuple(self.a.velocity), (2, 0))
        self.a.velocity, self.a.position = (5, 0), (0, 1)
        self.world.step()
        self.assertAlmostEqual(self.a.position.x, 0.01, 6)
        self.assertAlmostEqual(self.a.interpolated(0).x, 0, 6)
        self.a.apply_force((0, 4000))
        self.world.step()
        self.assertAlmostEqual(self.a.velocity.y, 2, 4)
        self.a.pinned = True
        self.assertTrue(self.a.pinned)

    def test_joints(self):
        joint = self.world.connect(self.a, self.b, stiffness=100)
        self.assertEqual((joint.rest_length, joint.stiffness), (2, 100))
        joint.stiffness, joint.damping, joint.rest_length, joint.strength = 200, 3, 1, 1000
        self.assertEqual((joint.stiffness, joint.damping, joint.rest_length, joint.strength),
                         (200, 3, 1, 1000))
        self.world.step()
        self.assertGreater(joint.force, 100)
        joint.material = sulfur.material(restitution=1)
        self.assertEqual(joint.material.restitution, 1)
        joint.material = None
        self.assertEqual(joint.material.restitution, 0)
        self.assertEqual(self.world.connections, [joint])
        joint.remove()
        self.assertEqual(self.world.connections, [])

    def test_attachments_and_grabs(self):
        tie = self.world.attach(self.a, self.balls[1], (0, 0))
        self.assertEqual(self.world.attachments, [tie])
        self.assertEqual(tie.info.supports[0], self.b.id)
        tie.remove()
        rope = self.world.add(sulfur.rope(), position=(0, -1))
        link = self.world.attach(self.a, rope.joints[0], 0.25)
        self.assertEqual(list(link.info.weights)[:2], [0.75, 0.25])
        link.remove()
        grab = self.world.grab(self.balls[0], target=(0, 3), max_force=50)
        grab.set_target((0, 5))
        self.world.step()
        self.assertAlmostEqual(grab.info.force.y, 50, 3)
        self.assertEqual(self.world.grabs, [grab])
        grab.release()
        self.assertEqual(self.world.grab(self.a, (1, 1)).info.target.x, 1)

    def test_mechanisms(self):
        world = self.world
        ground = world.add(sulfur.floor((-9, -5), (9, -5)))
        hinge = world.hinge(ground, self.balls[0], (0, 0),
                            drive={"motor_speed": 2, "motor_max": 1000, "upper": 0.5})
        rack = world.slider(ground, self.balls[1], (2, 0), (0, 1), drive=sulfur.drive(lower=-9))
        world.gear(hinge, rack, -2)
        world.run(0.1)
        self.assertAlmostEqual(hinge.speed, 2, 2)
        self.assertAlmostEqual(rack.value, 0.1, 2)
        self.assertEqual(rack.drive.lower, -9)
        reached = []
        for _ in range(200):
            world.step()
            reached += world.events["limits_reached"]
        self.assertEqual([limit.mechanism for limit in reached], [hinge.id])
        self.assertTrue(hinge.info.at_upper)
        hinge.change_drive(motor_target=0.25)
        world.run(0.5)
        self.assertAlmostEqual(hinge.value, 0.25, 3)
        hinge.change_drive(motor_target=None)
        self.assertFalse(hinge.drive.has_motor_target)
        self.assertEqual([m.info.kind for m in world.mechanisms],
                         [sulfur.c.HINGE, sulfur.c.SLIDER, sulfur.c.GEAR])
        hinge.remove()
        self.assertFalse(hinge.exists)

    def test_a_slider_on_a_rail(self):
        ground = self.world.add(sulfur.floor((-9, -1), (9, -1)))
        slider = self.world.slider(ground, self.balls[1], (2, 0), rail=ground.joints, value=3)
        self.assertAlmostEqual(slider.value, 3 + 11, 5)
        self.assertEqual(slider.rail, ground.joints)
        self.assertEqual(slider.info.rail_begin, 3)
        with self.assertRaisesRegex(sulfur.Error, "the rail has no joint"):
            self.world.slider(ground, self.balls[0], (0, 0), rail=[])

    def test_other_mechanisms(self):
        world, (a, b) = self.world, self.balls
        frame = world.add(sulfur.floor((-1, 5), (3, 5)))
        rope = world.pulley(a, (0, 0), (0, 5), b, (2, 0), (2, 5), frame, ratio=2, length=16)
        self.assertAlmostEqual(rope.value, 15, 5)
        self.assertEqual((rope.info.drive.upper, rope.info.ratio), (16, 2))
        rod = world.distance(a, (0, 0), b, (2, 0), drive={"stiffness": sulfur.INFINITE, "rest": 2})
        self.assertAlmostEqual(rod.value, 2, 5)
        spring, motor = world.wheel(frame, a, (0, 0), (0, 1), spring={"stiffness": 100},
                                    motor={"motor_speed": 3, "motor_max": 1})
        self.assertEqual((spring.drive.stiffness, motor.drive.motor_speed), (100, 3))
        crate = world.add(sulfur.box(), position=(0, 1))
        weld = world.weld(a, crate, (0, 0), stiffness=50)
        self.assertEqual((weld.info.kind, weld.drive.stiffness), (sulfur.c.WELD, 50))
        with self.assertRaisesRegex(TypeError, "WeldOptions has no option lower"):
            world.weld(a, b, (0, 0), lower=1)

    def test_fields(self):
        wind = self.world.add_field(sulfur.wind_field(velocity=(3, 0), drag=50))
        self.world.add_field(sulfur.radial_field(centre=(0, 9), strength=4))
        self.world.add_field(sulfur.uniform_field(
            acceleration=(0, 9), zone=sulfur.box_zone((5, 5), (6, 6))))
        self.assertEqual(len(self.world.fields), 3)
        self.assertEqual(self.world.fields[2].info.uniform.zone.high.x, 6)
        self.world.run(0.5)
        self.assertGreater(self.balls[0].velocity.x, 1)
        wind.set(sulfur.wind_field(zone=sulfur.circle_zone((0, 0), 2)))
        self.assertEqual(wind.info.wind.zone.radius, 2)
        wind.remove()
        self.assertFalse(wind.exists)


class Queries(unittest.TestCase):
    def setUp(self):
        self.world = sulfur.World()
        self.crate = self.world.add(sulfur.box())
        self.ball = self.world.add(sulfur.ball(), position=(3, 0))

    def test_casts(self):
        world, crate, ball = self.world, self.crate, self.ball
        hit = world.cast_segment((-5, 0), (5, 0))
        self.assertEqual(hit.body, crate.id)
        self.assertAlmostEqual(hit.fraction, 0.45, 6)
        self.assertEqual(world.cast_segment((-5, 0), (5, 0), ignore=crate).body, ball.id)
        hit = world.cast_ray((-5, 0), (1, 0), 99, accept=lambda body: body != crate)
        self.assertEqual(hit.body, ball.id)
        self.assertIsNone(world.cast_ray((-5, 0), (-1, 0), 99))
        self.assertEqual(len(world.cast_all((-5, 0), (5, 0))), 3)
        hit = world.cast_shape(sulfur.rectangle((0, 5), (1, 1)), (0, -10))
        self.assertAlmostEqual(hit.fraction, 0.4, 6)
        self.assertAlmostEqual(world.closest_point((3, 1), 5).distance, 0.75, 6)

    def test_overlaps(self):
        world = self.world
        for shape in (sulfur.circle((3, 0), 0.1), sulfur.capsule((2, 0), (4, 0), 0.1),
                      sulfur.hull([(2, 0), (4, 0), (3, 1)])):
            self.assertEqual([found.body for found in world.overlap(shape)], [self.ball.id])
        self.assertEqual(world.bodies_at((3, 0)), [self.ball])
        self.assertEqual(world.bodies_in((-1, -1), (4, 1)), [self.crate, self.ball])
        self.assertEqual(world.nearest_particle((3, 0.5), 1), self.ball.particles[0])
        self.assertIsNone(world.nearest_particle((3, 9), 1))

    def test_what_a_filter_raises_is_raised(self):
        def accept(body):
            raise KeyError(body.name)

        with self.assertRaises(KeyError):
            self.world.bodies_at((0, 0), accept=accept)
        self.assertEqual(self.world.bodies_at((0, 0)), [self.crate])

    def test_drawing(self):
        class Visitor:
            bodies, discs = 0, []

            def body(self, body):
                self.bodies += 1

            def disc(self, disc):
                self.discs.append(disc.radius)

        visitor = Visitor()
        self.world.draw(visitor)
        self.assertEqual((visitor.bodies, visitor.discs), (2, [0.25]))
        self.world.draw(visitor, bodies=False, view=sulfur.circle_zone((50, 0), 1))
        self.assertEqual((visitor.bodies, visitor.discs), (2, [0.25]))

        class Broken:
            def body(self, body):
                raise KeyError("body")

        with self.assertRaises(KeyError):
            self.world.draw(Broken())


class Worlds(unittest.TestCase):
    def test_go_on_alike(self):
        world, crate = crate_on_floor()
        world.run(0.05)
        start, twin = world.snapshot(), world.clone()
        pool = sulfur.ThreadPool(2)
        twin.set_thread_pool(pool)
        del pool
        gc.collect()
        for w in (world, twin):
            w.run(1)
        self.assertEqual(world.hash, twin.hash)
        self.assertEqual(tuple(twin.body(crate).position), tuple(crate.position))
        after = world.hash
        world.restore(start)
        self.assertNotEqual(world.hash, after)
        world.run(1)
        self.assertEqual(world.hash, after)
        twin.set_thread_pool(None)

    def test_tell_what_happens(self):
        world, crate = crate_on_floor()
        begun = []
        for _ in range(200):
            world.step()
            begun += world.events["contacts_begun"]
        self.assertEqual(len(begun), 1)
        self.assertIn(crate.id, (begun[0].a, begun[0].b))
        self.assertGreater(begun[0].impulse, 0)
        weight = sum(contact.impulse for contact in world.contacts) / world.tick_duration
        self.assertAlmostEqual(weight, 2 * 9.81, 2)

    def test_have_numbers_and_settings(self):
        world = sulfur.World(tick_rate=100, gravity=(0, -5), air_friction=0.25, sleeping=False)
        world.add(sulfur.ball())
        world.set_profiling(True)
        world.run(1)
        self.assertFalse(world.settings.has_sleep_speed)
        calm = sulfur.World(sleep_speed=0.25, rebound_speed=0.5).settings
        self.assertEqual((calm.sleep_speed, calm.rebound_speed), (0.25, 0.5))
        self.assertEqual((world.ticks, world.tick_rate, world.gravity.y), (100, 100, -5))
        self.assertAlmostEqual(world.time, 1, 9)
        self.assertTrue(math.isfinite(world.energy))
        self.assertEqual(world.statistics.bodies, 1)
        self.assertGreater(sum(world.statistics.seconds), 0)
        self.assertEqual(sulfur.stage_name(0), "changes")
        self.assertIn("rigid components", [part.name.decode() for part in world.memory])
        world.gravity, world.air_friction, world.tick_rate = (1, 2), 0.5, 200
        world.damper = c.FULL_DAMPER
        self.assertEqual(tuple(world.gravity), (1, 2))
        self.assertEqual((world.air_friction, world.tick_rate, world.damper),
                         (0.5, 200, c.FULL_DAMPER))
        self.assertEqual(world.validate(), "")

    def test_outlive_nothing_that_is_asked_of_them(self):
        body = crate_on_floor()[1]
        gc.collect()
        self.assertEqual(body.kind, sulfur.DYNAMIC)


class Callbacks(unittest.TestCase):
    def setUp(self):
        self.world, self.crate = crate_on_floor()
        self.floor = self.world.bodies[0]

    def test_say_who_collides(self):
        asked = []

        def should_collide(a, b):
            asked.append((a, b))
            return b.mass > 5

        self.world.set_should_collide(should_collide)
        del should_collide
        gc.collect()
        self.world.run(0.5)
        self.assertEqual(asked, [(self.floor, self.crate)])
        self.assertLess(self.crate.position.y, -0.5)
        self.world.set_should_collide(None)
        self.crate.pose = ((0, 0.6), 0)
        self.world.run(0.5)
        self.assertEqual(len(asked), 1)

    def test_say_how_contacts_act(self):
        contacts = []

        def belt(contact, surface):
            contacts.append(contact)
            surface.surface_speed = 2
            return True

        self.world.set_pre_solve(belt)
        self.world.run(1)
        self.assertAlmostEqual(abs(self.crate.velocity.x), 2, 1)
        self.assertEqual(contacts[0].a, self.floor.id)
        self.assertAlmostEqual(contacts[0].normal.y, -1, 5)
        self.world.set_pre_solve(lambda contact, surface: False)
        self.world.run(0.5)
        self.assertLess(self.crate.position.y, -0.5)
        self.world.set_pre_solve(None)

    def test_raise_out_of_the_step(self):
        other, _ = crate_on_floor()
        calls = []

        def broken(contact, surface):
            calls.append(contact)
            surface.surface_speed = 2
            raise KeyError("contact")

        for world in (self.world, other):
            world.run(0.2)
        self.world.set_pre_solve(broken)
        with self.assertRaises(KeyError):
            self.world.step()
        other.step()
        self.assertEqual((len(calls), self.world.hash), (1, other.hash))
        self.world.set_pre_solve(lambda contact, surface: setattr(surface, "restitution", 7))
        with self.assertRaisesRegex(sulfur.Error, "restitution"):
            self.world.step()
        self.world.set_pre_solve(None)
        other.step()
        self.assertEqual(self.world.hash, other.hash)

    def test_change_nothing(self):
        self.world.set_should_collide(lambda a, b: b.remove())
        with self.assertRaises(sulfur.Error) as raised:
            self.world.run(1)
        self.assertEqual(raised.exception.code, c.IN_CALLBACK)
        self.assertTrue(self.crate.exists)

    def test_do_not_keep_their_world(self):
        world, _ = crate_on_floor()
        world.set_should_collide(lambda a, b: True)
        world.set_pre_solve(lambda contact, surface: True)
        world.step()
        gone = weakref.ref(world)
        gc.disable()
        try:
            del world, _
            self.assertIsNone(gone())
        finally:
            gc.enable()


class Errors(unittest.TestCase):
    def test_are_raised_with_the_words_of_the_library(self):
        world, crate = crate_on_floor()
        before = world.hash
        for code, text, function in (
                (c.OUT_OF_RANGE, "tick rate", lambda: sulfur.World(tick_rate=3)),
                (c.NOT_FINITE, "gravity", lambda: setattr(world, "gravity", (math.nan, 0))),
                (c.BAD_SNAPSHOT, "damaged", lambda: world.restore(b"nothing")),
                (c.OUT_OF_RANGE, "mass", lambda: sulfur.box(mass=-1)),
                (c.STALE_HANDLE, "7:1", lambda: world.body(c.BodyId(7, 1))),
                (c.OUT_OF_RANGE, "alpha", lambda: crate.interpolated_pose(2))):
            with self.assertRaisesRegex(sulfur.Error, text) as raised:
                function()
            self.assertEqual(raised.exception.code, code, text)
        self.assertEqual(world.hash, before)


class Version(unittest.TestCase):
    def test_is_the_project_s(self):
        with open(PROJECT, encoding="utf-8") as file:
            version = re.search(r"VERSION ([\d.]+)", file.read().split("project(")[1]).group(1)
        self.assertEqual(sulfur.VERSION, version)


PROJECT = sys.argv.pop()  # the top-level CMakeLists.txt

if __name__ == "__main__":
    unittest.main()
