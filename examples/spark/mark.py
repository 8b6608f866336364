"""Answers marked under Apache Spark: `carom mark --stream` is a filter, and Spark runs filters on all its machines.

    python3 examples/spark/mark.py KEY.json ANSWERS.csv MARKS

ANSWERS.csv is a table of submissions, or a folder of such tables; MARKS becomes a folder of JSON lines in the order of the
students. `carom` is on the path, or the variable CAROM says where it is; of a cluster, every machine has it and the key.
"""

import os
import shlex
import sys

from pyspark.sql import SparkSession
from pyspark.sql.functions import monotonically_increasing_id

key, answers, marks = sys.argv[1:]
carom = shlex.join([os.environ.get("CAROM", "carom"), "mark", key, "-", "--stream"])

spark = SparkSession.builder.appName("carom").getOrCreate()
# Working has line breaks in its cells, and quotes in quotes are written twice. An empty answer is an answer.
table = spark.read.csv(answers, header=True, multiLine=True, escape='"').na.fill("")
# All rows of a student together, and in the order in which they were handed in: the last answer to a question counts.
rows = table.withColumn("place", monotonically_increasing_id())
rows = rows.repartitionByRange("student").sortWithinPartitions("student", "place").drop("place")
rows.toJSON().pipe(carom, checkCode=True).saveAsTextFile(marks)
