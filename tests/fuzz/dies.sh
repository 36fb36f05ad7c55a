#!/bin/sh
# Stands for a program that crashes: the fuzz test must notice.
kill -SEGV $$
