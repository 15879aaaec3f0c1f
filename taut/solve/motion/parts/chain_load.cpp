#include "taut/solve/motion/parts/chain_load.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/rope_load.hpp"

namespace taut::solve::dynamics {
namespace {

constexpr double whole_share = 1e-12;

double length_of_chain(const ChainLoad& load, const Values& v) {
  double length = 0;
  for (int i = 0; i < load.count; ++i) length += v.lines[load.lines[i]].l;
  return length;
}

/// The segment that encloses the place, and its share there.
void find_segment(const ChainLoad& load, const Values& v, ChainLoadValues& is) {
  const double whole = length_of_chain(load, v);
  double left = std::clamp(load.follows * whole + load.more, 0.0, whole);
  for (int i = 0; i < load.count; ++i) {
    is.line = load.lines[i];
    const double l = v.lines[is.line].l;
    if (left <= l || i + 1 == load.count) {
      is.share = std::clamp(left / l, 0.0, 1.0);
      return;
    }
    left -= l;
  }
}

double share_at(const ChainLoadValues& is, std::size_t end) { return end == 0 ? 1 - is.share : is.share; }

/// Way of an end of a free line from `before` to `now`, as its body carries it, along t, m.
double way_of_end(const Line& line, std::size_t i, std::size_t end, const Vector3& t, const Values& before,
                  const Values& now) {
  if (line.body[end] < 0) return 0;
  return t.dot(now.lines[i].touch[end] - before.lines[i].touch[end]);
}

struct Ways {
  double rope = 0, place = 0;  ///< along the segment, m
};

/// Of the rope at the place, by the segment and the directions of `of`.
Ways ways_at(const Mechanism& m, const ChainLoad& load, const ChainLoadValues& is, const Values& of,
             const Values& before, const Values& now) {
  Ways ways;
  const Line& line = m.lines[is.line];
  const LineValues& shape = of.lines[is.line];
  for (const std::size_t end : {0U, 1U}) {
    double way = way_of_end(line, as_size(is.line), end, shape.t, before, now);
    if (line.contact[end] >= 0) {
      const std::size_t c = as_size(m.contacts[line.contact[end]].column);
      way += (1 + shape.e) * (now.q[c] - before.q[c]);
    }
    ways.rope += share_at(is, end) * way;
  }
  const std::size_t first = as_size(load.lines.front()), last = as_size(load.lines.back());
  ways.place = (1 - load.follows) * way_of_end(m.lines[first], first, 0, shape.t, before, now) +
               load.follows * way_of_end(m.lines[last], last, 1, shape.t, before, now);
  return ways;
}

/// Speed of the rope seen from the place, m/s.
double speed_at(const Mechanism& m, const ChainLoad& load, const ChainLoadValues& is, const Values& v) {
  const auto of_end = [&](std::size_t i, std::size_t end) {
    if (m.lines[i].body[end] < 0) return 0.0;
    const Motion3& body = v.bodies[m.lines[i].body[end]];
    return v.lines[is.line].t.dot(body.v + body.w.cross(v.lines[i].touch[end] - body.x));
  };
  const Line& line = m.lines[is.line];
  double speed = 0;
  for (const std::size_t end : {0U, 1U}) {
    double here = of_end(as_size(is.line), end);
    if (line.contact[end] >= 0) here += (1 + v.lines[is.line].e) * v.contacts[line.contact[end]].flow;
    speed += share_at(is, end) * here;
  }
  return speed - (1 - load.follows) * of_end(as_size(load.lines.front()), 0) -
         load.follows * of_end(as_size(load.lines.back()), 1);
}

/// What the ends of the segment get along it; a rope at a round can't be pushed there: the joint gets the rest.
void share_out(const Mechanism& m, ChainLoadValues& is, LineValues& rope) {
  const Line& line = m.lines[is.line];
  is.bounded = {false, false};
  for (const std::size_t end : {0U, 1U}) is.on_end[end] = share_at(is, end) * is.force;
  for (const std::size_t end : {0U, 1U}) {
    if (line.contact[end] < 0) continue;
    const double sign = end == 0 ? 1 : -1;
    const double tension = rope.end_T[end] + sign * is.on_end[end];
    if (tension < 0) {
      is.bounded[end] = true;
      const double taken = -sign * std::max(0.0, rope.end_T[end]);
      is.on_end[1 - end] += is.on_end[end] - taken;
      is.on_end[end] = taken;
    }
    rope.end_T[end] += sign * is.on_end[end];
  }
}

}  // namespace

void add_chain_loads(Mechanism& m, TimeMethod method) {
  constexpr double stiff = 20;
  const auto& ropes = m.model->reevings;
  const auto stands = [&](int body) {
    return body < 0 || (m.bodies[body].count == 0 && m.model->bodies[body].driven.empty());
  };
  for (std::size_t r = 0; r < ropes.size(); ++r) {
    const machine::Reeving& rope = ropes[r];
    if (rope.segments <= 1) continue;
    const int nodes = static_cast<int>(rope.nodes.size());
    for (int node = 0; node < nodes; ++node) {
      if (rope.nodes[node].kind != machine::NodeKind::load) continue;
      ChainLoad load;
      load.as.reeving = static_cast<int>(r);
      load.as.node = node;
      load.as.body = rope.nodes[node].at.body;
      load.as.load = true;
      load.bristle = method == TimeMethod::verlet ? 1 : stiff;  // explicit steps are as short as segments ask for
      load.as.copies = rope.copies;
      const int from = line_end(rope, node, 0), to = line_end(rope, node, 1);
      const int branches = (to - from + nodes) % nodes;
      load.count = branches * rope.segments;
      const auto [first, lines] = m.first_line[r];
      for (int i = 0; i < load.count; ++i) load.lines.push_back(first + (from * rope.segments + i) % lines);
      const int start = rope.nodes[from].at.body, end = rope.nodes[to].at.body;
      load.follows = stands(start) ? 0.0 : stands(end) ? 1.0 : rope.nodes[node].load.share;
      m.chain_loads.push_back(load);
    }
  }
}

void place_chain_loads(const DynamicState& start, Mechanism& m, Values& now) {
  now.chain_loads.assign(m.chain_loads.size(), {});
  for (std::size_t i = 0; i < m.chain_loads.size(); ++i) {
    ChainLoad& load = m.chain_loads[i];
    const double whole = length_of_chain(load, now);
    double place = m.model->reevings[load.as.reeving].nodes[load.as.node].load.share * whole;
    if (!start.ropes[load.as.reeving].passed.empty()) {  // a motion that goes on has the place among its bodies
      const Vector3& x = start.bodies[load.as.body].position;
      double before = 0, nearest = std::numeric_limits<double>::infinity();
      for (const int k : load.lines) {
        const LineValues& line = now.lines[k];
        const double along = std::clamp(line.t.dot(x - line.touch[0]), 0.0, line.l);
        const double off = (line.touch[0] + along * line.t - x).norm();
        if (off < nearest - whole_share * whole) {
          nearest = off;
          place = before + along;
        }
        before += line.l;
      }
    }
    load.more = place - load.follows * whole;
    find_segment(load, now, now.chain_loads[i]);
    const LineValues& line = now.lines[now.chain_loads[i].line];
    now.bodies[load.as.body].x = line.touch[0] + now.chain_loads[i].share * line.l * line.t;
  }
}

void follow_chain_loads(const Mechanism& m, const Scheme& s, const Values& before, Values& now) {
  for (std::size_t i = 0; i < m.chain_loads.size(); ++i) {
    const ChainLoad& load = m.chain_loads[i];
    const ChainLoadValues& was = before.chain_loads[i];
    ChainLoadValues& is = now.chain_loads[i];
    find_segment(load, now, is);
    LineValues& rope = now.lines[is.line];
    const RopeLoadStep step = rope_load(m, load.as, now.when, was.speed, s.lossless);
    is.stiffness = 0;
    is.bristle = was.bristle;
    is.holds = step.holds;
    if (!step.holds) {
      is.force = -step.drop;
      is.bristle = 0;
    } else {
      const Ways ways = s.h > 0 ? ways_at(m, load, is, now, before, now) : Ways{};
      const double stiffness = load.bristle * m.lines[is.line].stiffness / rope.L;
      const double most = step.drop / stiffness, stretched = was.bristle + ways.rope - ways.place;
      is.bristle = std::clamp(stretched, -most, most);
      if (most > 0 && is.bristle == stretched) is.stiffness = stiffness;
      is.force = -stiffness * is.bristle;
    }
    is.speed = speed_at(m, load, is, now);
    share_out(m, is, rope);
    now.bodies[load.as.body].x = rope.touch[0] + is.share * rope.l * rope.t;
  }
}

void assemble_chain_loads(Mechanism& m, const Scheme& s, const Values& now, Work& w) {
  const double square = s.reach * s.reach;
  for (std::size_t i = 0; i < m.chain_loads.size(); ++i) {
    const ChainLoadValues& is = now.chain_loads[i];
    const Line& line = m.lines[is.line];
    const LineValues& rope = now.lines[is.line];
    line_columns(line, m.bodies, now.bodies, rope, w.columns);
    const int freedoms = line.freedoms[0] + line.freedoms[1];
    const auto end_of = [&](int k) -> std::size_t { return k < line.freedoms[0] ? 0 : 1; };
    for (int r = 0; r < freedoms; ++r) {
      w.residual[line.column[as_size(r)]] -=
          line.copies * is.on_end[end_of(r)] * rope.t.dot(w.columns[as_size(r)].velocity);
    }
    if (!w.tangent) continue;
    std::array<double, 14> slope{};  // of the force
    for (int k = 0; k < freedoms; ++k) {
      const double way = square * rope.t.dot(w.columns[as_size(k)].velocity);
      slope[as_size(k)] = -is.stiffness * share_at(is, end_of(k)) * way;
    }
    for (const std::size_t end : {0U, 1U}) {
      if (line.flow[end] >= 0 && s.h > 0)
        slope[as_size(line.flow[end])] = -is.stiffness * share_at(is, end) * (1 + rope.e);
    }
    auto& values = m.solver.values();
    for (int r = 0; r < freedoms; ++r) {
      const std::size_t end = end_of(r);
      const Vector3& V = w.columns[as_size(r)].velocity;
      const double share = is.bounded[end] ? 0 : is.bounded[1 - end] ? 1 : share_at(is, end);
      for (int k = 0; k < line.columns; ++k) {
        double Q = share * slope[as_size(k)] * rope.t.dot(V);
        if (k < freedoms) Q += is.on_end[end] * square * w.columns[as_size(k)].t.dot(V);
        values[line.places[r * line.columns + k]] -= line.copies * Q;
      }
    }
    for (const std::size_t end : {0U, 1U}) {
      if (line.contact[end] < 0 || is.bounded[end]) continue;
      const double sign = end == 0 ? 1 : -1;
      for (int k = 0; k < line.columns; ++k) {
        w.tangents[is.line].end_T[end][as_size(k)] += sign * share_at(is, end) * slope[as_size(k)];
      }
    }
  }
}

ChainLoadWork work_of_chain_loads(const Mechanism& m, const Values& before, const Values& now) {
  ChainLoadWork work;
  for (std::size_t i = 0; i < m.chain_loads.size(); ++i) {
    const ChainLoad& load = m.chain_loads[i];
    for (const Values* of : {&before, &now}) {
      const ChainLoadValues& is = of->chain_loads[i];
      const Ways ways = ways_at(m, load, is, *of, before, now);
      const double half = load.as.copies * is.force / 2;
      if (now.chain_loads[i].holds) {
        work.lost -= half * (ways.rope - ways.place);
        work.supplied += half * ways.place;
      } else {
        work.supplied += half * ways.rope;
      }
    }
  }
  return work;
}

TransientFrame::Contact chain_load_frame(const Mechanism& m, const Values& v, std::size_t i) {
  const ChainLoadValues& is = v.chain_loads[i];
  const LineValues& rope = v.lines[is.line];
  TransientFrame::Contact c;
  c.reeving = m.chain_loads[i].as.reeving;
  c.node = m.chain_loads[i].as.node;
  c.T_in = std::max(0.0, rope.T + is.on_end[0]);
  c.T_out = std::max(0.0, rope.T - is.on_end[1]);
  c.flow = c.slip = is.speed;
  c.state = is.holds && is.stiffness > 0 ? ContactState::stuck : ContactState::slipping;
  c.force = (c.T_out - c.T_in) * rope.t;
  return c;
}

}  // namespace taut::solve::dynamics
