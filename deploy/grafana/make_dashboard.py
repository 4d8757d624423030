#!/usr/bin/env python3
"""Writes tilemend.json, the dashboard, from the panels below: `make_dashboard.py > tilemend.json`.

Five rows answer an operator's five questions. A panel is a title, a unit and its queries as (legend, PromQL).
"""
import json

C = 'tilemend_coordinator_'
ROWS = [
    ('Throughput: how fast does the cluster work?', [
        ('Tasks finished per second', 'ops', [('{{stage}}', f'sum by (stage) (rate({C}tasks_finished_total[1m]))')]),
        ('Holes and cells per second', 'ops', [('holes', f'sum(rate({C}holes_filled_total[1m]))'),
                                               ('cells', f'sum(rate({C}cells_done_total[1m]))')]),
        ('New triangles per second', 'ops', [('triangles', f'sum(rate({C}triangles_total[1m]))')]),
        ('Bytes to and from workers', 'Bps', [('sent', f'sum(rate({C}blob_sent_bytes_total[1m]))'),
                                              ('received', f'sum(rate({C}blob_received_bytes_total[1m]))')]),
    ]),
    ('Progress: how far is each job?', [
        ('Share done of each running job', 'percentunit', [('slot {{slot}}', f'{C}running_job_done_ratio >= 0')]),
        ('Age of each running job', 's', [('slot {{slot}}', f'{C}running_job_age_seconds >= 0')]),
        ('Time left of each running job, guessed', 's', [
            ('slot {{slot}}', f'({C}running_job_age_seconds * (1 - {C}running_job_done_ratio) / '
                              f'({C}running_job_done_ratio > 0.02)) >= 0')]),
    ]),
    ('Queue: is there work that waits, and are there workers?', [
        ('Tasks that wait and that run, and slots', 'short', [('wait', f'sum({C}tasks_pending)'),
                                                              ('run', f'sum({C}tasks_running)'),
                                                              ('slots', f'sum({C}task_slots)')]),
        ('Workers', 'short', [('connected', f'sum({C}workers_connected)'), ('set aside', f'sum({C}workers_set_aside)'),
                              ('blind', f'sum({C}workers_blind)')]),
        ('Jobs now', 'short', [('{{state}}', f'sum by (state) ({C}jobs)')]),
    ]),
    ('Failures: does anything go wrong?', [
        ('Attempts that failed, per hour', 'short', [
            ('failed', f'sum(increase({C}tasks_failed_total[1h]))'),
            ('given out again', f'sum(increase({C}tasks_retried_total[1h]))'),
            ('quarantined', f'sum(increase({C}tasks_quarantined_total[1h]))'),
            ('refused as wrong', f'sum(increase({C}results_refused_total[1h]))')]),
        ('Jobs that ended, per day', 'short', [('{{state}}', f'sum by (state) (increase({C}jobs_ended_total[1d]))')]),
        ('Workers lost, and alerts that fire', 'short', [
            ('lost per hour', f'sum(increase({C}workers_lost_total[1h]))'),
            ('alerts', 'count(ALERTS{alertstate="firing"}) or vector(0)')]),
    ]),
    ('Latency: how long does it take?', [
        ('Seconds of a task, 95 in 100', 's', [
            ('{{stage}}', f'histogram_quantile(0.95, sum by (stage, le) (rate({C}task_seconds_bucket[5m]))) >= 0')]),
        ('Seconds of a job, and until its first task', 's', [
            ('job, median', f'histogram_quantile(0.5, sum by (le) (rate({C}job_seconds_bucket[1h])))'),
            ('queue, median', f'histogram_quantile(0.5, sum by (le) (rate({C}job_queue_seconds_bucket[1h])))')]),
        ('Seconds of a call, 95 in 100', 's', [
            ('{{rpc}}', f'histogram_quantile(0.95, sum by (rpc, le) '
                        f'(rate({C}rpc_seconds_bucket{{rpc!="tilemend.v1.Jobs/WatchJob"}}[5m]))) >= 0')]),
    ]),
    ('The programs', [
        ('Memory used of what there may be', 'percentunit', [
            ('{{instance}}', 'process_resident_memory_bytes{job=~"tilemend-.*"} / tilemend_memory_limit_bytes')]),
        ('Cores used', 'short', [('{{instance}}', 'rate(process_cpu_seconds_total{job=~"tilemend-.*"}[1m])')]),
        ('Size of the journal', 'bytes', [('journal', f'sum({C}journal_bytes)')]),
    ]),
]


def panel(number, title, unit, queries, x, y, w):
    return {'id': number, 'title': title, 'type': 'timeseries', 'datasource': {'type': 'prometheus', 'uid': 'prometheus'},
            'gridPos': {'x': x, 'y': y, 'w': w, 'h': 7},
            'fieldConfig': {'defaults': {'unit': unit, 'min': 0}, 'overrides': []},
            'options': {'legend': {'showLegend': True, 'placement': 'bottom'}, 'tooltip': {'mode': 'multi'}},
            'targets': [{'refId': chr(65 + i), 'expr': expr, 'legendFormat': legend}
                        for i, (legend, expr) in enumerate(queries)]}


def dashboard():
    panels, number, y = [], 1, 0
    for title, row in ROWS:
        panels.append({'id': number, 'type': 'row', 'title': title, 'collapsed': False, 'panels': [],
                       'gridPos': {'x': 0, 'y': y, 'w': 24, 'h': 1}})
        number, y = number + 1, y + 1
        for i, (name, unit, queries) in enumerate(row):
            width = 24 // len(row)
            panels.append(panel(number, name, unit, queries, width * i, y, width))
            number += 1
        y += 7
    return {'uid': 'tilemend', 'title': 'tilemend', 'schemaVersion': 37, 'version': 1, 'refresh': '10s',
            'time': {'from': 'now-1h', 'to': 'now'}, 'timezone': 'utc', 'tags': ['tilemend'], 'panels': panels}


if __name__ == '__main__':
    print(json.dumps(dashboard(), indent=1))
