"""Decks that several tests run."""

MAST = """taut: 1
title: case A
method: mast_section
input:
  skyline_force: 100 kN
  mainline_force: 40 kN
  skyline_block_height: 8 m
  branch_angle: 12 deg
  wrap: paper
  allowable_stress: 160 MPa
"""
