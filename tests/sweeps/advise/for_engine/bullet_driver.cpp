// Runs a beam that plastica has written for Bullet in Bullet itself; its header is included from
// the command line.
//
//   bullet_driver LINK X Y Z <ROWS
//
// A row a step: gravity, force and moment in world axes on LINK (the force at X Y Z from its
// center, in its axes), and how far the ground has turned, three numbers each. Prints after each
// step the coordinates of all links, then where the outer end of the last one is.

#include <cstdio>
#include <cstdlib>

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <btBulletCollisionCommon.h>

int main(int count, char** arguments) {
  if (count != 8) return 2;
  const int loaded = std::atoi(arguments[1]);
  const auto number = [&](int i) { return btScalar(std::atof(arguments[i])); };
  const btVector3 place(number(2), number(3), number(4));
  const btVector3 end(number(5), number(6), number(7));
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btMultiBodyConstraintSolver solver;
  btMultiBodyDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  btMultiBody* beam = plastica_beam::Build(world);
  const int last = plastica_beam::kNumberOfLinks - 1;
  double row[12];
  for (;;) {
    for (double& value : row) {
      if (std::scanf("%lf", &value) == 1) continue;
      world.removeMultiBody(beam);
      delete beam;
      return 0;
    }
    const auto vector = [&](int k) {
      return btVector3(btScalar(row[k]), btScalar(row[k + 1]), btScalar(row[k + 2]));
    };
    const double turned[3] = {row[9], row[10], row[11]};
    world.setGravity(vector(0));
    const btVector3 arm = beam->localDirToWorld(loaded, place);
    beam->addLinkForce(loaded, vector(3));
    beam->addLinkTorque(loaded, vector(6) + arm.cross(vector(3)));
    plastica_beam::AddSprings(*beam, turned);
    world.stepSimulation(btScalar(plastica_beam::kTimeStep), 0);
    for (int i = 0; i <= last; ++i) std::printf("%.17g ", double(beam->getJointPos(i)));
    const btVector3 tip = beam->localPosToWorld(last, end);
    std::printf("%.17g %.17g %.17g\n", double(tip[0]), double(tip[1]), double(tip[2]));
  }
}
