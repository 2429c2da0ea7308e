// A contribution to the equations that is not an item, such as general contact. It reads frames of markers and adds forces
// there, like connectors, but selects the interacting pairs itself, and updates them between steps and iterations:
//
//   begin of a step          keep, search
//     Newton's method        residual, tangent    found pairs stay fixed: entries of the matrix have their slots
//     after it has converged post_newton          history; an error if something was missed
//     to be iterated again   search
//   step failed              restore
//
// If a search changes the entries of `visit`, slots are looked up again; the pattern of the matrix is made anew, and analysed, only
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
  // Called once, for the system in which it acts: finds coordinates of objects that it reads without markers.
  virtual void enter(const System&, const Model&) {}
  // Finds markers at nodes, when the assembly is complete.
  virtual void find_nodes(const System&) {}
  // Whether it reads nodes directly if Evaluation::reads_nodes is set, and adds forces there; other markers need
  // ports.
  virtual bool reads_nodes() const { return false; }
  bool reads_totals() const override { return !reads_nodes(); }
  virtual bool needs_port(std::size_t /*of_markers*/) const { return true; }
  // Explicit integration needs neither search nor history: contacts are then detected in each evaluation.
  virtual bool direct() const { return false; }
  // Updates the active pairs from the frames in the ports. Returns whether they have changed.
  virtual bool search(const Evaluation& evaluation, const Ports& ports) = 0;
  // Threads that may help it, until the next call; null: none.
  virtual void use_workers(Workers*) {}
  // History: remembered as it is at the begin of a step, and set back to that.
  virtual void keep() {}
  // Discards results of earlier searches that influence the pattern; returns true if there were any.
  virtual bool forget() { return false; }
  virtual void restore() {}
  // Whether it has history in explicit integration: `post_newton` is then called after each step.
  virtual bool has_history_of_steps() const { return false; }
  // History at the start of a solution, where those with history of steps find their frames; and as numbers of a restart file, of which the
  // first ones are taken off.
  virtual void begin_history(const Ports&) {}
  virtual void write_history(std::vector<double>& /*numbers*/) const {}
  virtual bool take_history(std::span<const double>& /*numbers*/) { return true; }  // false: they do not fit
  // Keeps the switches found at the last switch-over; watching starts with those found next.
  virtual void forget_switches() {}
  virtual std::string name_of_part(int /*part*/) const { return {}; }  // name of a part in Switches

  void add(const void*, const Placement&, const Ports&) final {}  // it is no list of items
  void refresh(int, const void*) final {}
};

}  // namespace dalembert
