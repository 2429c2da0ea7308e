// A contribution to the equations that is no item, such as contact of everything with everything. It reads frames of markers and
// leaves forces there, as connectors do, but chooses by itself what acts on what, and chooses again between steps and iterations:
//
//   begin of a step          keep, search
//     Newton's method        residual, tangent    what was found stays as it is: entries of the matrix have their slots
//     after it has converged post_newton          history; an error if something was missed
//     to be iterated again   search
//   step failed              restore
//
// When a search changes what `visit` names, slots are looked up again; the pattern of the matrix is made anew, and analysed, only
// if it lacks one of the entries.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "dalembert/system/term.hpp"

namespace dalembert {

class Model;
class System;
class Workers;

class SystemTerm : public Term {
 public:
  // All that it may ever act on.
  virtual std::span<const int> markers() const = 0;
  // Once, in the system that it acts in: where the coordinates are of objects that it reads without markers.
  virtual void enter(const System&, const Model&) {}
  // Which markers lie at nodes, from now on.
  virtual void find_nodes(const System&) {}
  // Whether it reads those itself where Evaluation::reads_nodes says so, and leaves forces there; of the others it needs ports.
  virtual bool reads_nodes() const { return false; }
  bool reads_totals() const override { return !reads_nodes(); }
  virtual bool needs_port(std::size_t /*of_markers*/) const { return true; }
  // Explicit integration needs neither search nor history of it: without these it finds what acts in each evaluation.
  virtual bool direct() const { return false; }
  // Looks for what acts from now on, by the frames in the ports. True: that has changed.
  virtual bool search(const Evaluation& evaluation, const Ports& ports) = 0;
  // Threads that may help it, until others are given; null: none.
  virtual void use_workers(Workers*) {}
  // History: remembered as it is at the begin of a step, and set back to that.
  virtual void keep() {}
  // Drops what it has kept of earlier searches, on which the pattern depends; true: there was something.
  virtual bool forget() { return false; }
  virtual void restore() {}
  // Whether it has history in explicit integration too: it is told after each step, as others are, by `post_newton`.
  virtual bool has_history_of_steps() const { return false; }
  // History at the start of a solution, where those with history of steps find their frames; and as numbers of a restart file, of which the
  // first ones are taken off.
  virtual void begin_history(const Ports&) {}
  virtual void write_history(std::vector<double>& /*numbers*/) const {}
  virtual bool take_history(std::span<const double>& /*numbers*/) { return true; }  // false: they do not fit
  // What it has found when it was told to switch over; it begins with what it finds next.
  virtual void forget_switches() {}
  virtual std::string name_of_part(int /*part*/) const { return {}; }  // of which Switches tell

  void add(const void*, const Placement&, const Ports&) final {}  // it is no list of items
  void refresh(int, const void*) final {}
};

}  // namespace dalembert
